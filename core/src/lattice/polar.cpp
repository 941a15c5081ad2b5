// SPDX-License-Identifier: MIT
#include "lattice/polar.h"

namespace lumi::detail::polar
{
// Lists the Delaunay triangles with a corner below kReach, by their lowest corner.
constexpr uint8_t kCorners[kTriangles][3] = {
    {0, 2, 1},    {0, 1, 3},    {0, 5, 2},    {0, 3, 8},    {0, 8, 5},    {1, 2, 4},    {1, 6, 3},    {1, 4, 9},
    {1, 9, 6},    {2, 7, 4},    {2, 5, 10},   {2, 15, 7},   {2, 10, 15},  {3, 6, 11},   {3, 16, 8},   {3, 11, 16},
    {4, 7, 12},   {4, 17, 9},   {4, 12, 17},  {5, 8, 13},   {5, 18, 10},  {5, 13, 18},  {6, 9, 14},   {6, 19, 11},
    {6, 14, 19},  {7, 20, 12},  {7, 15, 20},  {8, 21, 13},  {8, 16, 21},  {9, 22, 14},  {9, 17, 30},  {9, 30, 22},
    {10, 23, 15}, {10, 18, 31}, {10, 31, 23}, {11, 24, 16}, {11, 19, 32}, {11, 32, 24}, {12, 25, 17}, {12, 20, 33},
    {12, 33, 25}, {13, 26, 18}, {13, 21, 34}, {13, 34, 26}, {14, 27, 19}, {14, 22, 35}, {14, 35, 27}, {15, 28, 20},
    {15, 23, 36}, {15, 36, 28}, {16, 29, 21}, {16, 24, 37}, {16, 37, 29}, {17, 25, 38}, {17, 38, 30}, {18, 26, 39},
    {18, 39, 31}, {19, 27, 40}, {19, 40, 32}, {20, 28, 41}, {20, 41, 33}, {21, 29, 42}, {21, 42, 34}, {22, 30, 43},
    {22, 43, 35}, {23, 31, 44}, {23, 44, 36}};

namespace
{

constexpr bool has(const uint8_t corner[3], uint8_t c)
{
    return corner[0] == c || corner[1] == c || corner[2] == c;
}

// Returns the triangle across the edge opposite corner e of triangle k.
constexpr uint8_t beyond_of(int k, int e)
{
    for (int other = 0; other < kWalkTriangles; ++other) {
        const uint8_t* c = kCorners[other];
        if (other != k && has(c, kCorners[k][(e + 1) % 3]) && has(c, kCorners[k][(e + 2) % 3]))
            return static_cast<uint8_t>(other);
    }
    return kNone;
}

constexpr int16_t quotient_q14(int32_t part, int32_t whole)
{
    const double v = 16384.0 * 4096 * part / whole;
    return static_cast<int16_t>(v + (v < 0 ? -0.5 : 0.5));
}

// Returns the gradient of the weight opposite the edge from `a` on to `b`, in a triangle of twice the area `area_q24`.
constexpr Gradient gradient(PlanePoint a, PlanePoint b, int32_t area_q24)
{
    return {quotient_q14(a.y_q12 - b.y_q12, area_q24), quotient_q14(b.x_q12 - a.x_q12, area_q24)};
}

constexpr TriangleWalk make_walk(int k)
{
    const uint8_t* const corner = kCorners[k];
    const PlanePoint p0 = kPattern.point[corner[0]];
    const PlanePoint p1 = kPattern.point[corner[1]];
    const PlanePoint p2 = kPattern.point[corner[2]];
    const int32_t area_q24 =
        (p1.x_q12 - p0.x_q12) * (p2.y_q12 - p0.y_q12) - (p1.y_q12 - p0.y_q12) * (p2.x_q12 - p0.x_q12);
    return {{beyond_of(k, 0), beyond_of(k, 1), beyond_of(k, 2)},
            {gradient(p2, p0, area_q24), gradient(p0, p1, area_q24)}};
}

constexpr Walks make_walks()
{
    Walks walks{};
    for (int k = 0; k < kWalkTriangles; ++k) walks.triangle[k] = make_walk(k);
    return walks;
}

constexpr bool are_short(const Walks& walks)
{
    for (const TriangleWalk& t : walks.triangle) {
        for (const Gradient& g : t.weight)
            if (g.x_q14 * g.x_q14 + g.y_q14 * g.y_q14 >= 1 << 28) return false;
    }
    return true;
}

}  // namespace

constexpr Walks kWalks = make_walks();
static_assert(are_short(kWalks));

}  // namespace lumi::detail::polar
