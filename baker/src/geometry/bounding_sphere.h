// SPDX-License-Identifier: MIT
// The smallest sphere around a set of points.
#pragma once

#include <array>
#include <vector>

#include "math/vec3.h"

namespace lumi::baker
{

struct BoundingSphere {
    std::array<double, 3> centre;
    double radius;
};

// Within 1e-6 of the smallest radius, and never too small: every point is inside. `points` is not empty. Cost: a few
// passes over the points.
BoundingSphere smallest_sphere(const std::vector<Vec3>& points);

}  // namespace lumi::baker
