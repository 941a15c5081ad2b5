// SPDX-License-Identifier: MIT
// How the light that leaves a diffuse body spreads over directions, as a factor to the even spread of Lambert's law.
//
// A body of known roughness has Burley's shape: a smooth one darkens towards the horizon, a rough one sends light back
// to where it came from. Burley, "Physically Based Shading at Disney", SIGGRAPH 2012 course, section 5.3; the
// Principled shader of Blender has it. It is symmetric in the two directions. Its mean is 0.95 for roughness 0, 1.0 for
// 0.5, and 1.07 for 1.
#pragma once

#include "math/vec3.h"

namespace lumi::baker
{

class DiffuseShape
{
public:
    DiffuseShape() = default;  // Lambert's
    // roughness in [0, 1].
    explicit DiffuseShape(float roughness) : roughness_(roughness), rough_(true) {}

    // `facing`: the cosine between a direction and the one halfway to the other.
    float at(const Vec3& wo, const Vec3& wi, float facing) const
    {
        if (!rough_) return 1;
        const float grazing = 2 * roughness_ * facing * facing - 0.5f;  // what the horizon gains
        return (1 + grazing * fifth_power(1 - wo.z)) * (1 + grazing * fifth_power(1 - wi.z));
    }

private:
    static float fifth_power(float x) { return x * x * x * x * x; }

    float roughness_ = 0;
    bool rough_ = false;
};

}  // namespace lumi::baker
