// SPDX-License-Identifier: MIT
// Values and densities that several kinds of surface share. Directions as in bsdf.h.
#pragma once

#include <optional>
#include <variant>

#include "material/microfacet.h"
#include "math/vec3.h"

namespace lumi::baker
{

// Returns the Fresnel reflectance of unpolarized light.

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

// Evaluates Schlick's approximation for conductors, from the colour at normal incidence.
inline Rgb schlick_reflectance(float cosine, const Rgb& f0)
{
    const float m = std::clamp(1 - cosine, 0.0f, 1.0f);
    return f0 + (grey(1) - f0) * (m * m * m * m * m);
}

// Below this mean loss a table's error is larger than what it says.
inline constexpr float kNegligibleLoss = 1e-4f;
inline constexpr float kSchlickMeanWeight = 1.0f / 21;  // ∫ 2·cos·(1-cos)^5

inline constexpr float kInvPi = 1 / kPi;

inline float cosine_pdf(const Vec3& wi)
{
    return wi.z > 0 ? wi.z * kInvPi : 0.0f;
}

// Density of the mirror direction of a sampled facet.
template <class Spread>
float reflection_pdf(const GgxOf<Spread>& facets, const Vec3& wo, const Vec3& wi)
{
    if (wi.z <= 0) return 0;
    const Vec3 half = normalized(wo + wi);
    return facets.pdf_half(wo, half) / (4 * std::max(dot(wo, half), 1e-7f));
}

// Returns the Torrance-Sparrow reflection times cos θi, without the Fresnel factor.
template <class Spread>
float reflection_value(const GgxOf<Spread>& facets, const Vec3& wo, const Vec3& wi, const Vec3& half)
{
    return facets.density(half) * facets.masking_shadowing(wo, wi) / (4 * wo.z);
}

// The direction that a body under a layer sends on; `body` is a variant of kinds of surface.
template <class Body>
std::optional<Vec3> body_direction(const Body& body, const Vec3& wo, float u_lobe, const Vec2& u)
{
    const auto sample = std::visit([&](const auto& b) { return b.sample(wo, u_lobe, u); }, body);
    return sample ? std::optional<Vec3>(sample->wi) : std::nullopt;
}

}  // namespace lumi::baker
