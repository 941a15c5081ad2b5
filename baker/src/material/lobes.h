// SPDX-License-Identifier: MIT
// Values and densities that several kinds of surface share. Directions as in bsdf.h.
#pragma once

#include <optional>
#include <variant>

#include "material/fresnel.h"
#include "material/microfacet.h"

namespace lumi::baker
{

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

// Torrance-Sparrow reflection times cos θi, without the Fresnel factor.
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
