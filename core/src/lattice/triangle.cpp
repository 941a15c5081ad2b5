// SPDX-License-Identifier: MIT
#include "lattice/hull_triangle.h"
#include "lattice/lattice_query.h"
#include "lattice/polar.h"
#include "lattice/polar_triangle.h"
#include "lumi/detail/lattice.h"

namespace lumi::detail
{
namespace
{

Triangle unmirrored(const Lattice& lattice, const Query& q, const PolarTriangle& t)
{
    Triangle result;
    for (int m = 0; m < 3; ++m) {
        result.index[m] = unmirrored(lattice, q, t.corners[m]);
        result.weight_q12[m] = t.weight_q12[m];
    }
    return result;
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
