// SPDX-License-Identifier: MIT
// Fresnel reflectance of unpolarized light.
#pragma once

#include "math/vec3.h"

namespace lumi::baker
{

// Exact, of a dielectric whose far side has the index eta relative to the near side; 1 where eta < 1 reflects totally.
// cosine in [0, 1].
inline float dielectric_reflectance(float cosine, float eta)
{
    const float sine2 = (1 - cosine * cosine) / (eta * eta);
    const float inner = std::sqrt(std::max(0.0f, 1 - sine2));
    const float parallel = (eta * cosine - inner) / (eta * cosine + inner);
    const float perpendicular = (cosine - eta * inner) / (cosine + eta * inner);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

inline Vec3 mirrored(const Vec3& wo, const Vec3& half)
{
    return half * (2 * dot(wo, half)) - wo;
}

// Snell's law about the facet normal `half`, dot(wo, half) > 0; of use only where the reflectance is below 1.
inline Vec3 refracted(const Vec3& wo, const Vec3& half, float eta)
{
    const float cosine = dot(wo, half);
    const float sine2 = (1 - cosine * cosine) / (eta * eta);
    return half * (cosine / eta - std::sqrt(std::max(0.0f, 1 - sine2))) - wo / eta;
}

// Schlick's approximation for conductors, from the colour at normal incidence.
inline Rgb schlick_reflectance(float cosine, const Rgb& f0)
{
    const float m = std::clamp(1 - cosine, 0.0f, 1.0f);
    return f0 + (grey(1) - f0) * (m * m * m * m * m);
}

}  // namespace lumi::baker
