// SPDX-License-Identifier: MIT
// The triangle around a direction: of a cell of the lattice, of the polar pattern around a pole, or of the hull of
// small lattices, where the pattern of one pole reaches into the other's. Functions that are not inlined do not take
// their stack beside each other's.
#include "lattice/lattice_query.h"
#include "lattice/polar.h"
#include "lumi/detail/lattice.h"
#include "lumi/detail/math.h"

namespace lumi::detail
{
namespace
{

constexpr uint32_t kMinHull = 4;

// The points around a direction as seen along it: places in a plane in which the direction is the origin, and depths.
struct Outlook {
    int32_t x_q30[kMaxNeighbours], y_q30[kMaxNeighbours], depth_q30[kMaxNeighbours];

    Outlook(const Lattice& lattice, const Vec3q30& direction, const Neighbour* near, uint32_t count)
    {
        // The plane's axes are perpendicular to the direction, though not to each other: areas keep their ratios.
        const int32_t along[3] = {direction.x, direction.y, direction.z};
        int a = 0;
        for (int k = 1; k < 3; ++k)
            if (magnitude(along[k]) > magnitude(along[a])) a = k;
        const int b = a == 2 ? 0 : a + 1, c = a == 0 ? 2 : a - 1;
        for (uint32_t k = 0; k < count; ++k) {
            const Vec3q30 p = point(lattice, near[k].index);
            const int32_t place[3] = {p.x, p.y, p.z};
            x_q30[k] = mul_q30(along[a], place[b]) - mul_q30(along[b], place[a]);
            y_q30[k] = mul_q30(along[a], place[c]) - mul_q30(along[c], place[a]);
            depth_q30[k] = dot_q30(direction, p);
        }
    }

    // Returns twice the area of the direction and points i and j, Q28.
    int32_t area_q28(uint32_t i, uint32_t j) const
    {
        return static_cast<int32_t>((wide_product(x_q30[i], y_q30[j]) - wide_product(x_q30[j], y_q30[i])) >> 32);
    }
};

// A triangle through which the direction passes: its parts, and how far out, as a quotient.
struct Passed {
    uint32_t corners[3] = {0, 0, 0};
    int32_t part_q28[3] = {1, 0, 0};
    int32_t distance_q28 = 0, area_q28 = 1;

    // Takes three points if they are passed farther out. Not inlined: its stack is not beside that of point().
    __attribute__((noinline)) void consider(const Outlook& from, uint32_t i, uint32_t j, uint32_t k)
    {
        int32_t part[3] = {from.area_q28(j, k), from.area_q28(k, i), from.area_q28(i, j)};
        const uint32_t corner[3] = {i, j, k};
        const int32_t sign = (part[0] | part[1] | part[2]) < 0 ? -1 : 1;
        int32_t distance = 0, area = 0;
        for (int m = 0; m < 3; ++m) {
            part[m] *= sign;
            if (part[m] < 0) return;
            distance += mul_q30(part[m], from.depth_q30[corner[m]]);
            area += part[m];
        }
        if (wide_product(distance, area_q28) <= wide_product(distance_q28, area)) return;
        *this = {{i, j, k}, {part[0], part[1], part[2]}, distance, area};
    }
};

// Not inlined: nearest_of_all() has returned its stack before the outlook takes its own.
__attribute__((noinline)) Passed outermost(const Lattice& lattice, const Vec3q30& direction, const Neighbour* near,
                                           uint32_t count)
{
    const Outlook outlook(lattice, direction, near, count);
    Passed best;  // rounding may leave a gap at a point: it alone
    for (uint32_t k = 2; k < count; ++k)
        for (uint32_t j = 1; j < k; ++j)
            for (uint32_t i = 0; i < j; ++i) best.consider(outlook, i, j, k);
    return best;
}

// Linear in height between the two points whose heights are next.
Triangle between_heights(const Lattice& lattice, int32_t z_q30)
{
    const auto last = static_cast<int32_t>(lattice.size() - 1);
    const int32_t height_q10 = lattice.index_at_q10(z_q30);
    const int32_t held_q10 = height_q10 < 0 ? 0 : height_q10 < last << 10 ? height_q10 : last << 10;
    const auto above = static_cast<uint32_t>(held_q10 >> 10);
    const auto below = above < static_cast<uint32_t>(last) ? above + 1 : above;
    const uint32_t weight_q12 = static_cast<uint32_t>(held_q10 & 1023) << 2;
    return {{above, below, below}, {kWeightOneQ12 - weight_q12, weight_q12, 0}};
}

// The triangle of the points' convex hull that a direction points at, weighted by where it meets it. Below 4 points,
// whose hull does not surround the centre: the two points next in height. Looks at the nearest 9 points, of which the
// hull's triangle are three for every size below 64 (tests/core/lattice/triangle_test.cpp).
__attribute__((noinline)) Triangle hull_triangle(const Lattice& lattice, const Vec3q30& direction)
{
    LUMI_TALLY(Work::hull_triangle, 1);
    if (lattice.size() < kMinHull) return between_heights(lattice, direction.z);
    Neighbour near[kMaxNeighbours];
    const uint32_t count = nearest_of_all(lattice, direction, kMaxNeighbours, near);
    const Passed passed = outermost(lattice, direction, near, count);
    Triangle result{};
    uint32_t rest = kWeightOneQ12;
    for (int m = 2; m >= 0; --m) {
        // Parts are at most 2^28, their sum is below 2^30.
        const auto part_q19 = static_cast<uint32_t>(passed.part_q28[m]) >> 9;
        result.index[m] = near[passed.corners[m]].index;
        result.weight_q12[m] = m == 0 ? rest : part_q19 * kWeightOneQ12 / (static_cast<uint32_t>(passed.area_q28) >> 9);
        rest -= result.weight_q12[m];
    }
    return result;
}

// Corners are points of the pattern (lattice/polar.h), for both poles alike; weights sum to kWeightOneQ12.
struct PolarTriangle {
    const uint8_t* corners;
    uint32_t weight_q12[3];
};

struct PolarPosition {
    int32_t x_q12, y_q12;
};

// Lambert's projection of a unit vector: x and y, scaled by sqrt(n/(2·(1 + |z|))) = n/sqrt(2·n·(1 + |z|)).
PolarPosition projected(const Lattice& lattice, const Vec3q30& direction, int32_t height_z_q30)
{
    const uint64_t above_q30 = static_cast<uint64_t>(kOneQ30) + static_cast<uint32_t>(height_z_q30);
    const ReciprocalRoot root = reciprocal_root(2 * lattice.size() * above_q30);  // of 2^37 to 2^52 where n >= 64
    const auto scale_q20 = static_cast<int32_t>((uint64_t{lattice.size()} * root.mantissa) >> (root.exponent - 35));
    return {static_cast<int32_t>(wide_product(direction.x, scale_q20) >> 38),
            static_cast<int32_t>(wide_product(direction.y, scale_q20) >> 38)};
}

// A place around the south pole in the pattern: its mirror image i -> n-1-i.
PolarPosition mirrored(const Lattice& lattice, const PolarPosition& p)
{
    const SinCos mirror = sin_cos(longitude_turns32(lattice.size() - 1));
    return {mul_q30(p.x_q12, mirror.cos_q30) + mul_q30(p.y_q12, mirror.sin_q30),
            mul_q30(p.x_q12, mirror.sin_q30) - mul_q30(p.y_q12, mirror.cos_q30)};
}

// Returns twice the area of the triangle (a, b, p), Q24.
int32_t area_q24(polar::PlanePoint a, polar::PlanePoint b, const PolarPosition& p)
{
    return (b.x_q12 - a.x_q12) * (p.y_q12 - a.y_q12) - (b.y_q12 - a.y_q12) * (p.x_q12 - a.x_q12);
}

// The parts into which a position divides a triangle of the polar pattern; a negative part: it lies outside.
struct PolarParts {
    const uint8_t* corners;
    int32_t area_q24[3];
    int32_t smallest_q24;
};

// Takes triangle k if it holds the position, or misses it by less.
void improve(PolarParts& best, int k, const PolarPosition& p)
{
    const uint8_t* c = polar::corners(k);
    const polar::PlanePoint p0 = polar::plane_point(c[0]);
    const polar::PlanePoint p1 = polar::plane_point(c[1]);
    const int32_t opposite_2 = area_q24(p0, p1, p);
    if (opposite_2 <= best.smallest_q24) return;
    const polar::PlanePoint p2 = polar::plane_point(c[2]);
    const int32_t opposite_0 = area_q24(p1, p2, p);
    if (opposite_0 <= best.smallest_q24) return;
    const int32_t opposite_1 = area_q24(p2, p0, p);
    if (opposite_1 <= best.smallest_q24) return;
    const int32_t smaller = opposite_0 < opposite_1 ? opposite_0 : opposite_1;
    best = {c, {opposite_0, opposite_1, opposite_2}, smaller < opposite_2 ? smaller : opposite_2};
}

// Finds the triangle that holds the position or, where rounding leaves a gap, the one that misses it least.
PolarParts find(const PolarPosition& position)
{
    PolarParts best = {polar::corners(0), {0, 0, 0}, INT32_MIN};
    for (int k = 0; k < polar::kTriangles && best.smallest_q24 < 0; ++k) improve(best, k, position);
    return best;
}

// Finds the triangle of a direction whose real-valued index is below polar::kReach; `query` is make_query() of it. The
// place in the plane comes from x and y: a height does not resolve what lies around a pole.
__attribute__((noinline)) PolarTriangle polar_triangle(const Lattice& lattice, const Query& query,
                                                       const Vec3q30& direction)
{
    LUMI_TALLY(Work::polar_triangle, 1);
    const PolarPosition position = projected(lattice, direction, query.z_q30);
    const PolarParts found = find(query.mirrored ? mirrored(lattice, position) : position);
    uint32_t part[3];
    for (int m = 0; m < 3; ++m) part[m] = found.area_q24[m] > 0 ? static_cast<uint32_t>(found.area_q24[m]) >> 12 : 0;
    const uint32_t sum = part[0] + part[1] + part[2];
    const uint32_t w1 = part[1] * kWeightOneQ12 / sum;
    const uint32_t w2 = part[2] * kWeightOneQ12 / sum;
    return {found.corners, {kWeightOneQ12 - w1 - w2, w1, w2}};
}

// The query, moved from where longitude and height see it towards where the weights put it: all the way at
// polar::kBlendBegin, not at all at polar::kBlendEnd. Both are maps of one triangulation, and so is what lies between.
__attribute__((noinline)) Query blended(const Query& query, const PolarTriangle& weights)
{
    static_assert((polar::kBlendEnd - polar::kBlendBegin) << 10 == kWeightOneQ12, "heights in Q10 are shares in Q12");
    const int32_t share_q12 = (polar::kBlendEnd << 10) - query.height_q10;
    int32_t turns32 = 0;     // a triangle is less than 1/4 turn wide here
    int32_t height_q22 = 0;  // and its corners at most 21 indices away
    for (int m = 0; m < 3; ++m) {
        const auto weight_q12 = static_cast<int32_t>(weights.weight_q12[m]);
        const uint32_t corner = weights.corners[m];
        const auto turn = static_cast<int32_t>(longitude_turns32(corner) - query.longitude_turns32);
        turns32 += weight_q12 * (turn >> 12);
        height_q22 += weight_q12 * ((static_cast<int32_t>(corner) << 10) - query.height_q10);
    }
    Query moved = query;
    moved.longitude_turns32 += static_cast<uint32_t>((turns32 >> 12) * share_q12);
    moved.height_q10 += ((height_q22 >> 12) * share_q12) >> 12;
    return moved;
}

Triangle unmirrored(const Lattice& lattice, const Query& q, const PolarTriangle& t)
{
    Triangle result;
    for (int m = 0; m < 3; ++m) {
        result.index[m] = unmirrored(lattice, q, t.corners[m]);
        result.weight_q12[m] = t.weight_q12[m];
    }
    return result;
}

Triangle cell_triangle(const Lattice& lattice, const Query& q)
{
    constexpr int32_t kOne = static_cast<int32_t>(kWeightOneQ12);
    const Cell cell = cell_of(q);
    const int32_t corner = cell.first * (cell.u_q12 >> 12) + cell.second * (cell.v_q12 >> 12);
    const CellTriangle t =
        CellTriangle::of(cell.u_q12 & (kOne - 1), cell.v_q12 & (kOne - 1), kOne, !is_obtuse(lattice, cell, corner));
    Triangle result;
    for (int m = 0; m < 3; ++m) {
        const int32_t index = corner + t.first[m] * cell.first + t.second[m] * cell.second;
        result.index[m] = unmirrored(lattice, q, static_cast<uint32_t>(index));
        result.weight_q12[m] = static_cast<uint32_t>(t.weight[m]);
    }
    return result;
}

}  // namespace

Triangle triangle(const Lattice& lattice, const Vec3q30& direction)
{
    if (lattice.size() < kSmallSize) return hull_triangle(lattice, direction);
    const Query query = make_query(lattice, direction);
    if (query.height_q10 >= polar::kBlendEnd << 10) return cell_triangle(lattice, query);
    const PolarTriangle around_pole = polar_triangle(lattice, query, direction);
    if (query.height_q10 < polar::kBlendBegin << 10) return unmirrored(lattice, query, around_pole);
    return cell_triangle(lattice, blended(query, around_pole));
}

}  // namespace lumi::detail
