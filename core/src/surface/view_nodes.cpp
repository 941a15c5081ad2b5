// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/view_nodes.h"

#include "lumi/fixed.h"
#include "math/generate.h"
#include "math/reciprocal.h"

namespace lumi::detail
{
namespace
{

using format::kViewNodes;

constexpr int kTriangles = 65;
// Lists the Delaunay triangles of the nodes under Lambert's projection, counter-clockwise from the lowest node, without
// the longest three along the rim.
constexpr uint8_t kCorners[kTriangles][3] = {
    {0, 1, 3},    {0, 2, 1},    {0, 3, 8},    {0, 5, 2},    {0, 8, 5},    {1, 2, 4},    {1, 4, 9},    {1, 6, 3},
    {1, 9, 6},    {2, 5, 10},   {2, 7, 4},    {2, 10, 15},  {2, 15, 7},   {3, 6, 11},   {3, 11, 16},  {3, 16, 8},
    {4, 7, 12},   {4, 12, 17},  {4, 17, 9},   {5, 8, 13},   {5, 13, 18},  {5, 18, 10},  {6, 9, 14},   {6, 14, 19},
    {6, 19, 11},  {7, 15, 20},  {7, 20, 12},  {8, 16, 21},  {8, 21, 13},  {9, 17, 30},  {9, 22, 14},  {9, 30, 22},
    {10, 18, 31}, {10, 23, 15}, {10, 31, 23}, {11, 19, 32}, {11, 24, 16}, {11, 32, 24}, {12, 20, 33}, {12, 25, 17},
    {12, 33, 25}, {13, 21, 34}, {13, 26, 18}, {13, 34, 26}, {14, 22, 35}, {14, 27, 19}, {14, 35, 27}, {15, 23, 36},
    {15, 28, 20}, {15, 36, 28}, {16, 24, 37}, {16, 29, 21}, {16, 37, 29}, {17, 25, 38}, {17, 38, 30}, {18, 26, 39},
    {18, 39, 31}, {19, 27, 32}, {20, 28, 33}, {21, 29, 34}, {22, 30, 35}, {23, 31, 36}, {24, 32, 37}, {25, 33, 38},
    {26, 34, 39}};
constexpr uint8_t kNone = 0xFF;

// Places in the plane are in Q8, from 0 to kCells. Where to begin is known for squares of two cells by two.
constexpr int kCells = 32;
constexpr int kSquares = kCells / 2;
constexpr int32_t kScaleQ8 = 3264;  // factor on s and t: 1.25 of them reach the plane's sides
constexpr int32_t kMiddleQ8 = kCells * 128;

// The weights of corners 1 and 2, affine in the place.
struct Weight {
    int16_t right, down;  // Q12 a cell
    int32_t constant_q20;
};

struct ViewTables {
    Weight weight[kTriangles][2];
    uint8_t beyond[kTriangles][3];      // the triangle across the edge opposite a corner, or kNone
    uint8_t first[kSquares][kSquares];  // at a square's middle, or the nearest
};

struct Place {
    double s, t;
};

constexpr double absolute(double v)
{
    return v < 0 ? -v : v;
}

// Places are in cells.
constexpr Place place_of_node(uint32_t k)
{
    const double z = 1 - (2.0 * k + 1) / format::kViewLattice, r = generate::root(1 - z * z);
    const double turn = 2 * generate::kPi * generate::fraction(k / generate::kGolden);
    const double x = r * generate::sine(turn + generate::kPi / 2 > 2 * generate::kPi ? turn - 1.5 * generate::kPi
                                                                                     : turn + generate::kPi / 2);
    const double y = r * generate::sine(turn);
    const double d = (absolute(x) + absolute(y) + z) * 256 / kScaleQ8;
    return {(x + y) / d + kCells / 2, (x - y) / d + kCells / 2};
}

constexpr double area(const Place& a, const Place& b, const Place& c)
{
    return (b.s - a.s) * (c.t - a.t) - (c.s - a.s) * (b.t - a.t);
}

constexpr int32_t rounded(double v)
{
    return static_cast<int32_t>(v < 0 ? v - 0.5 : v + 0.5);
}

// The weight of the corner that is not `a` or `b`: 0 on the edge between them, 1 at itself.
constexpr Weight weight_opposite(const Place& a, const Place& b, double whole)
{
    const double s = (a.t - b.t) / whole, t = (b.s - a.s) / whole;
    return {static_cast<int16_t>(rounded(4096 * s)), static_cast<int16_t>(rounded(4096 * t)),
            rounded(-(1 << 20) * (s * a.s + t * a.t))};
}

constexpr bool has(const uint8_t* corners, uint8_t node)
{
    return corners[0] == node || corners[1] == node || corners[2] == node;
}

constexpr uint8_t beyond_of(int k, int corner)
{
    for (int other = 0; other < kTriangles; ++other)
        if (other != k && has(kCorners[other], kCorners[k][(corner + 1) % 3]) &&
            has(kCorners[other], kCorners[k][(corner + 2) % 3]))
            return static_cast<uint8_t>(other);
    return kNone;
}

constexpr ViewTables make_tables()
{
    ViewTables tables{};
    Place places[kViewNodes] = {};
    for (uint32_t k = 0; k < kViewNodes; ++k) places[k] = place_of_node(k);
    double least[kSquares][kSquares] = {};
    for (int k = 0; k < kTriangles; ++k) {
        const Place &a = places[kCorners[k][0]], &b = places[kCorners[k][1]], &c = places[kCorners[k][2]];
        const double whole = area(a, b, c);
        tables.weight[k][0] = weight_opposite(c, a, whole);
        tables.weight[k][1] = weight_opposite(a, b, whole);
        for (int e = 0; e < 3; ++e) tables.beyond[k][e] = beyond_of(k, e);
        for (int row = 0; row < kSquares; ++row) {
            for (int column = 0; column < kSquares; ++column) {
                const Place p = {2 * column + 1.0, 2 * row + 1.0};
                const double of_b = area(c, a, p) / whole, of_c = area(a, b, p) / whole, of_a = 1 - of_b - of_c;
                const double smallest = of_a < of_b ? (of_a < of_c ? of_a : of_c) : of_b < of_c ? of_b : of_c;
                if (k == 0 || smallest > least[row][column]) {
                    least[row][column] = smallest;
                    tables.first[row][column] = static_cast<uint8_t>(k);
                }
            }
        }
    }
    return tables;
}

constexpr ViewTables kTables = make_tables();

struct CellPlace {
    int32_t s_q8, t_q8;
};

int32_t within_plane(int32_t q8)
{
    return q8 < 0 ? 0 : q8 > kCells * 256 - 1 ? kCells * 256 - 1 : q8;
}

CellPlace place_of(int32_t x, int32_t y, int32_t z)
{
    const int32_t across = magnitude(x) + magnitude(y);
    const int32_t lowest = -((across * 13) >> 6);  // z >= -0.2 across
    const int32_t d = across + (z > lowest ? z : lowest);
    const Reciprocal r = reciprocal(static_cast<uint32_t>(d > 0 ? d : 1));
    const int32_t shift = 47 - r.leading - 16;
    const auto placed = [&](int32_t v) {
        return within_plane((times_q16(v * kScaleQ8, r.mantissa) >> shift) + kMiddleQ8);
    };
    return {placed(x + y), placed(x - y)};
}

int32_t weight_at(const Weight& w, const CellPlace& p)
{
    return (w.right * p.s_q8 + w.down * p.t_q8 + w.constant_q20 + (1 << 11)) >> 12;
}

// The triangle beyond the edge whose weight is the furthest below 0, of those that have one; kNone: the place is here.
uint8_t across_lowest(uint32_t k, const int32_t (&weight)[3])
{
    int32_t lowest = -2;  // what roundings leave says nothing
    uint8_t next = kNone;
    for (int m = 0; m < 3; ++m) {
        if (weight[m] >= lowest || kTables.beyond[k][m] == kNone) continue;
        lowest = weight[m];
        next = kTables.beyond[k][m];
    }
    return next;
}

}  // namespace

ViewTaps view_taps(int32_t x, int32_t y, int32_t z)
{
    constexpr int kMostSteps = 8;  // beyond the triangle of a square's middle
    const CellPlace p = place_of(x, y, z);
    uint32_t k = kTables.first[p.t_q8 >> 9][p.s_q8 >> 9];
    int32_t weight[3] = {};
    for (int step = 0;; ++step) {
        weight[1] = weight_at(kTables.weight[k][0], p);
        weight[2] = weight_at(kTables.weight[k][1], p);
        weight[0] = 256 - weight[1] - weight[2];
        if ((weight[0] | weight[1] | weight[2]) >= 0) break;
        const uint8_t next = across_lowest(k, weight);
        if (next == kNone || step == kMostSteps) break;
        k = next;
    }
    // Beside all triangles, or by a rounding: the nearest place on the rim, nearly.
    for (int m = 0; m < 3; ++m) weight[m] = weight[m] < 0 ? 0 : weight[m];
    const int32_t sum = weight[0] + weight[1] + weight[2];
    if (sum != 256) {
        const Reciprocal r = reciprocal(static_cast<uint32_t>(sum));
        const auto over_sum = [&](int32_t w) { return (w * static_cast<int32_t>(r.mantissa)) >> (39 - r.leading); };
        weight[1] = over_sum(weight[1]);
        weight[2] = over_sum(weight[2]);
        weight[0] = 256 - weight[1] - weight[2];
    }
    const auto share = [&](int m) { return static_cast<uint16_t>(weight[m]); };
    return {{kCorners[k][0], kCorners[k][1], kCorners[k][2]}, {share(0), share(1), share(2)}};
}

}  // namespace lumi::detail
