// SPDX-License-Identifier: MIT
#include "lattice/hull_triangle.h"

#include "lattice/lattice_query.h"

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

    // Twice the area of the direction and points i and j, Q28.
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

}  // namespace

Triangle hull_triangle(const Lattice& lattice, const Vec3q30& direction)
{
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

}  // namespace lumi::detail
