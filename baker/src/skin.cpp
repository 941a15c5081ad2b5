// SPDX-License-Identifier: MIT
#include "skin.h"

#include "fresnel.h"
#include "microfacet.h"

namespace lumi::baker
{
namespace
{

constexpr int kSide = 24;              // of the square grid of samples for one direction
constexpr float kLeastCosine = 1e-3f;  // stands in for the horizon itself, where the facets' functions have no value

// Mean weight of samples of visible facets, by the midpoint rule.
float directional_albedo(float cosine, float eta, float alpha)
{
    const Ggx facets(alpha);
    const Vec3 wo = direction_at(std::max(cosine, kLeastCosine), 0);
    float sum = 0;
    for (int k = 0; k < kSide * kSide; ++k) {
        const Vec2 u = {(static_cast<float>(k % kSide) + 0.5f) / kSide, (static_cast<float>(k / kSide) + 0.5f) / kSide};
        const Vec3 half = facets.sample_half(wo, u);
        const Vec3 wi = half * (2 * dot(wo, half)) - wo;
        if (wi.z > 0) {
            const float shadowing = facets.masking_shadowing(wo, wi) / facets.masking(wo);
            sum += dielectric_reflectance(std::min(dot(wo, half), 1.0f), eta) * shadowing;
        }
    }
    return sum / (kSide * kSide);
}

}  // namespace

Skin::Skin(float eta, float alpha) : eta_(eta), alpha_(alpha), mean_(0), table_()
{
    for (size_t k = 0; k <= kSteps; ++k) {
        table_[k] = directional_albedo(static_cast<float>(k) / kSteps, eta, alpha);
    }
    // The exact integral of 2·cosine·albedo over each step of the interpolated table.
    constexpr float kStep = 1.0f / kSteps;
    for (size_t k = 0; k < kSteps; ++k) {
        const float a = static_cast<float>(k) * kStep, b = a + kStep;
        mean_ += kStep / 3 * (table_[k] * (2 * a + b) + table_[k + 1] * (a + 2 * b));
    }
}

float Skin::albedo(float cosine) const
{
    const float place = std::clamp(cosine, 0.0f, 1.0f) * kSteps;
    const size_t k = std::min(static_cast<size_t>(place), kSteps - 1);
    const float f = place - static_cast<float>(k);
    return table_[k] * (1 - f) + table_[k + 1] * f;
}

}  // namespace lumi::baker
