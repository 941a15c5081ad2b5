// SPDX-License-Identifier: MIT
#include "lattice/lattice_query.h"
#include "lattice/polar.h"
#include "lumi/detail/cell_triangle.h"
#include "lumi/detail/lattice.h"
#include "lumi/detail/math.h"

namespace lumi::detail
{
namespace
{

struct PolarPosition {
    int32_t x_q12, y_q12;
};

// A query in the plane of the polar pattern.
PolarPosition polar_position(const Query& q)
{
    const int32_t radius_q12 = polar_radius_q12(q);
    const SinCos direction = sin_cos(q.longitude_turns32);
    return {mul_q30(radius_q12, direction.cos_q30), mul_q30(radius_q12, direction.sin_q30)};
}

// Twice the area of the triangle (a, b, p), Q24.
int32_t area_q24(polar::PlanePoint a, polar::PlanePoint b, const PolarPosition& p)
{
    return (b.x_q12 - a.x_q12) * (p.y_q12 - a.y_q12) - (b.y_q12 - a.y_q12) * (p.x_q12 - a.x_q12);
}

// The parts into which a position divides a triangle of the polar pattern; a negative part: it lies outside.
struct PolarParts {
    const uint8_t* corners;
    int32_t area[3];

    int32_t smallest() const
    {
        const int32_t first = area[0] < area[1] ? area[0] : area[1];
        return first < area[2] ? first : area[2];
    }
};

PolarParts divide(int k, const PolarPosition& p)
{
    const uint8_t* c = polar::corners(k);
    const polar::PlanePoint p0 = polar::plane_point(c[0]);
    const polar::PlanePoint p1 = polar::plane_point(c[1]);
    const polar::PlanePoint p2 = polar::plane_point(c[2]);
    return {c, {area_q24(p1, p2, p), area_q24(p2, p0, p), area_q24(p0, p1, p)}};
}

// The triangle of the polar pattern that holds the query; where rounding leaves a gap, the one that misses it least.
Triangle polar_triangle(const Lattice& lattice, const Query& q)
{
    const PolarPosition position = polar_position(q);
    PolarParts best = divide(0, position);
    for (int k = 1; k < polar::kPolarTriangles && best.smallest() < 0; ++k) {
        const PolarParts parts = divide(k, position);
        if (parts.smallest() > best.smallest()) best = parts;
    }
    uint32_t part[3];
    for (int m = 0; m < 3; ++m) part[m] = best.area[m] > 0 ? static_cast<uint32_t>(best.area[m]) >> 12 : 0;
    const uint32_t sum = part[0] + part[1] + part[2];
    const uint32_t w1 = part[1] * kWeightOneQ12 / sum;
    const uint32_t w2 = part[2] * kWeightOneQ12 / sum;
    return {{unmirrored(lattice, q, best.corners[0]), unmirrored(lattice, q, best.corners[1]),
             unmirrored(lattice, q, best.corners[2])},
            {kWeightOneQ12 - w1 - w2, w1, w2}};
}

// The triangle of a cell of the lattice.
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

// Too few points for a pattern: the nearest three, by the kernel's weights.
Triangle small_triangle(const Lattice& lattice, const Vec3q30& direction)
{
    Neighbour near[3];
    const uint32_t count = neighbours(lattice, direction, 3, near);
    for (uint32_t m = count; m < 3; ++m) near[m] = {near[0].index, lattice.spacing2()};
    Triangle result;
    kernel_weights(lattice, near, 3, result.weight_q12);
    for (int m = 0; m < 3; ++m) result.index[m] = near[m].index;
    return result;
}

}  // namespace

Triangle triangle(const Lattice& lattice, const Vec3q30& direction)
{
    if (lattice.size() < kSmallSize) return small_triangle(lattice, direction);
    const Query query = make_query(lattice, direction);
    return query.height_q10 < polar::kPolarHeight << 10 ? polar_triangle(lattice, query)
                                                        : cell_triangle(lattice, query);
}

}  // namespace lumi::detail
