// SPDX-License-Identifier: MIT
#include "polar.h"

namespace lumi::polar
{
namespace
{

// Delaunay triangles that reach into the cap, by their lowest corner.
constexpr uint8_t kCorners[kTriangles][3] = {
    {0, 2, 1},    {0, 1, 3},    {0, 5, 2},    {0, 3, 8},    {0, 8, 5},    {1, 2, 4},    {1, 6, 3},    {1, 4, 9},
    {1, 9, 6},    {2, 7, 4},    {2, 5, 10},   {2, 15, 7},   {2, 10, 15},  {3, 6, 11},   {3, 16, 8},   {3, 11, 16},
    {4, 7, 12},   {4, 17, 9},   {4, 12, 17},  {5, 8, 13},   {5, 18, 10},  {5, 13, 18},  {6, 9, 14},   {6, 19, 11},
    {6, 14, 19},  {7, 20, 12},  {7, 15, 20},  {8, 21, 13},  {8, 16, 21},  {9, 22, 14},  {9, 17, 30},  {9, 30, 22},
    {10, 23, 15}, {10, 18, 31}, {10, 31, 23}, {11, 24, 16}, {11, 19, 32}, {11, 32, 24}, {12, 25, 17}, {12, 20, 33},
    {12, 33, 25}, {13, 26, 18}, {13, 21, 34}, {13, 34, 26}, {14, 27, 19}, {14, 22, 35}, {14, 35, 27}, {15, 28, 20},
    {15, 23, 36}, {15, 36, 28}, {16, 29, 21}, {16, 24, 37}, {16, 37, 29}, {17, 25, 38}, {17, 38, 30}, {18, 26, 39},
    {18, 39, 31}, {19, 27, 40}, {19, 40, 32}, {20, 28, 41}, {20, 41, 33}};

// The triangle beyond the edge opposite each corner.
constexpr uint8_t kBeyond[kTriangles][3] = {
    {5, 1, 2},     {6, 3, 0},     {10, 0, 4},    {14, 4, 1},    {19, 2, 3},    {9, 7, 0},     {13, 1, 8},
    {17, 8, 5},    {22, 6, 7},    {16, 5, 11},   {20, 12, 2},   {26, 9, 12},   {32, 11, 10},  {23, 15, 6},
    {28, 3, 15},   {35, 14, 13},  {25, 18, 9},   {30, 7, 18},   {38, 17, 16},  {27, 21, 4},   {33, 10, 21},
    {41, 20, 19},  {29, 24, 8},   {36, 13, 24},  {44, 23, 22},  {39, 16, 26},  {47, 25, 11},  {42, 19, 28},
    {50, 27, 14},  {45, 22, 31},  {54, 31, 17},  {255, 29, 30}, {48, 12, 34},  {56, 34, 20},  {255, 32, 33},
    {51, 15, 37},  {58, 37, 23},  {255, 35, 36}, {53, 18, 40},  {60, 40, 25},  {255, 38, 39}, {55, 21, 43},
    {255, 43, 27}, {255, 41, 42}, {57, 24, 46},  {255, 46, 29}, {255, 44, 45}, {59, 26, 49},  {255, 49, 32},
    {255, 47, 48}, {255, 28, 52}, {255, 52, 35}, {255, 50, 51}, {255, 54, 38}, {255, 30, 53}, {255, 56, 41},
    {255, 33, 55}, {255, 58, 44}, {255, 36, 57}, {255, 60, 47}, {255, 39, 59}};

constexpr int16_t quotient_q14(int32_t part, int32_t whole)
{
    const double v = 16384.0 * 4096 * part / whole;
    return static_cast<int16_t>(v + (v < 0 ? -0.5 : 0.5));
}

// Of the corner opposite the edge from `a` on to `b`, in a triangle of twice the area `area_q24`.
constexpr Gradient gradient(PlanePoint a, PlanePoint b, int32_t area_q24)
{
    return {quotient_q14(a.y_q12 - b.y_q12, area_q24), quotient_q14(b.x_q12 - a.x_q12, area_q24)};
}

constexpr Triangle make_triangle(const uint8_t corner[3], const uint8_t beyond[3])
{
    const PlanePoint p0 = kPattern.point[corner[0]];
    const PlanePoint p1 = kPattern.point[corner[1]];
    const PlanePoint p2 = kPattern.point[corner[2]];
    const int32_t area_q24 =
        (p1.x_q12 - p0.x_q12) * (p2.y_q12 - p0.y_q12) - (p1.y_q12 - p0.y_q12) * (p2.x_q12 - p0.x_q12);
    return {{corner[0], corner[1], corner[2]},
            {beyond[0], beyond[1], beyond[2]},
            {gradient(p2, p0, area_q24), gradient(p0, p1, area_q24)}};
}

constexpr Mesh make_mesh()
{
    Mesh mesh{};
    for (int k = 0; k < kTriangles; ++k) mesh.triangle[k] = make_triangle(kCorners[k], kBeyond[k]);
    return mesh;
}

constexpr bool are_short(const Mesh& mesh)
{
    for (const Triangle& t : mesh.triangle) {
        for (const Gradient& g : t.weight) {
            if (g.x_q14 * g.x_q14 + g.y_q14 * g.y_q14 >= 1 << 28) return false;
        }
    }
    return true;
}

}  // namespace

constexpr Mesh kMesh = make_mesh();
static_assert(are_short(kMesh));

}  // namespace lumi::polar
