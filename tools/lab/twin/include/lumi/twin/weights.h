// SPDX-License-Identifier: MIT
// Which lattice points a hit reads and with what weight, from the definitions in lumi/detail/lattice.h and
// lumi/chord/reconstruction.h: core's policies without fixed point and without inverse maps. Slow: every point is
// looked at.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "lumi/twin/geometry.h"

namespace lumi::twin
{

// Index and weight; weights sum to 1.
using Weights = std::vector<std::pair<uint32_t, double>>;

// `all` is points(n), q a unit vector.

// The nearest `count` points (fewer if there are fewer), nearest first; in place of weights their squared distances.
Weights sorted_by_distance(const std::vector<Vec3>& all, const Vec3& q, uint32_t count);

// Between which heights, as real-valued indices, linear weights go over from the plane of a pole to longitude and
// height. A test can make both the same: a switch, which is not continuous.
struct Transition {
    double begin = 20, end = 24;
};

// lumi::Nearest, lumi::Linear, lumi::Paper<count>.
Weights nearest_weights(const std::vector<Vec3>& all, const Vec3& q);
Weights linear_weights(const std::vector<Vec3>& all, const Vec3& q, const Transition& transition = {});
Weights paper_weights(const std::vector<Vec3>& all, const Vec3& q, uint32_t count);

// One point for a direction, and whether it lies so close to a border that rounding may decide for another.
struct CellPoint {
    uint32_t index;
    bool uncertain;
};

// By Voronoi cells; uncertain within `border_share` mean point spacings of the cell's border.
CellPoint nearest_point(const std::vector<Vec3>& all, const Vec3& q, double border_share);

}  // namespace lumi::twin
