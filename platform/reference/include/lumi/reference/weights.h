// SPDX-License-Identifier: MIT
// Which lattice points a hit reads and with what weight, from the definitions in lumi/lattice.h and
// lumi/reconstruction.h: core's policies without fixed point and without inverse maps. Slow: every point is looked at.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "lumi/reference/geometry.h"

namespace lumi::reference
{

// Index and weight; weights sum to 1.
using Weights = std::vector<std::pair<uint32_t, double>>;

// `all` is points(n), q a unit vector.

// The nearest `count` points (fewer if there are fewer), nearest first; in place of weights their squared distances.
Weights sorted_by_distance(const std::vector<Vec3>& all, const Vec3& q, uint32_t count);

// lumi::Nearest, lumi::Linear, lumi::Paper<count>.
Weights nearest_weights(const std::vector<Vec3>& all, const Vec3& q);
Weights linear_weights(const std::vector<Vec3>& all, const Vec3& q);
Weights paper_weights(const std::vector<Vec3>& all, const Vec3& q, uint32_t count);

}  // namespace lumi::reference
