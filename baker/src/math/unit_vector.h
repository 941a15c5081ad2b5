// SPDX-License-Identifier: MIT
// Points of core's lattices as the baker's vectors.
#pragma once

#include "lumi/detail/math.h"
#include "math/vec3.h"

namespace lumi::baker
{

inline Vec3 unit_vector(const Vec3q30& p)
{
    constexpr double kUnit = 1.0 / kOneQ30;
    return normalized(
        {static_cast<float>(p.x * kUnit), static_cast<float>(p.y * kUnit), static_cast<float>(p.z * kUnit)});
}

}  // namespace lumi::baker
