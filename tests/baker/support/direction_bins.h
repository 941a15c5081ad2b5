// SPDX-License-Identifier: MIT
// Bins of equal solid angle over the sphere of directions, for tests of how samples are distributed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "math/vec3.h"

namespace lumi::baker::testing
{

// heights x turns bins, turns first; `d` is a unit vector.
inline size_t direction_bin(const Vec3& d, int heights, int turns)
{
    const float turn = std::min(std::atan2(d.y, d.x) / (2 * kPi) + 0.5f, 0.99999f);
    const float height = std::min((d.z + 1) / 2, 0.99999f);
    const size_t row = static_cast<size_t>(height * static_cast<float>(heights));
    return row * static_cast<size_t>(turns) + static_cast<size_t>(turn * static_cast<float>(turns));
}

}  // namespace lumi::baker::testing
