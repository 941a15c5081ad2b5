// SPDX-License-Identifier: MIT
// Fresnel reflectance of unpolarized light.
#pragma once

#include "vec3.h"

namespace lumi::baker
{

// Exact, for light that comes from the outside of a dielectric of relative index eta > 1. cosine in [0, 1].
inline float dielectric_reflectance(float cosine, float eta)
{
    const float sine2 = (1 - cosine * cosine) / (eta * eta);
    const float inner = std::sqrt(std::max(0.0f, 1 - sine2));
    const float parallel = (eta * cosine - inner) / (eta * cosine + inner);
    const float perpendicular = (cosine - eta * inner) / (cosine + eta * inner);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

// Schlick's approximation for conductors, from the colour at normal incidence.
inline Rgb schlick_reflectance(float cosine, const Rgb& f0)
{
    const float m = std::clamp(1 - cosine, 0.0f, 1.0f);
    return f0 + (grey(1) - f0) * (m * m * m * m * m);
}

}  // namespace lumi::baker
