// SPDX-License-Identifier: MIT
#include "skin.h"

#include "fresnel.h"
#include "microfacet.h"

namespace lumi::baker
{
namespace
{

// Of the samples for one direction: a Fibonacci lattice, whose steps are neighbouring Fibonacci numbers.
constexpr int kSamples = 610, kStep = 377;

// Mean of weight(wo, half, facets) over samples of visible facets.
template <class Weight>
float directional_albedo(float cosine, float alpha, const Weight& weight)
{
    const Ggx facets(alpha);
    const Vec3 wo = direction_at(cosine, 0);
    float sum = 0;
    for (int k = 0; k < kSamples; ++k) {
        const Vec2 u = {(static_cast<float>(k) + 0.5f) / kSamples,
                        (static_cast<float>(k * kStep % kSamples) + 0.5f) / kSamples};
        sum += weight(wo, facets.sample_half(wo, u), facets);
    }
    return std::min(sum / kSamples, 1.0f);
}

// What a sampled facet reflects or refracts, without the Fresnel factor.
float passed_on(const Vec3& wo, const Vec3& wi, const Ggx& facets)
{
    return facets.masking_shadowing(wo, wi) / facets.masking(wo);
}

float reflected(const Vec3& wo, const Vec3& half, const Ggx& facets)
{
    const Vec3 wi = mirrored(wo, half);
    return wi.z > 0 ? passed_on(wo, wi, facets) : 0.0f;
}

float transmitted(const Vec3& wo, const Vec3& half, const Ggx& facets, float eta)
{
    const Vec3 wi = refracted(wo, half, eta);
    return wi.z < 0 ? passed_on(wo, wi, facets) : 0.0f;
}

AlbedoTable glass_side(float eta, float alpha)
{
    const auto weight = [eta](const Vec3& wo, const Vec3& half, const Ggx& facets) {
        const float f = dielectric_reflectance(std::min(dot(wo, half), 1.0f), eta);
        return f * reflected(wo, half, facets) + (f < 1 ? (1 - f) * transmitted(wo, half, facets, eta) : 0);
    };
    return AlbedoTable([&](float cosine) { return directional_albedo(cosine, alpha, weight); });
}

}  // namespace

Skin::Skin(float eta, float alpha)
    : eta_(eta), alpha_(alpha), table_([eta, alpha](float cosine) {
          return directional_albedo(cosine, alpha, [eta](const Vec3& wo, const Vec3& half, const Ggx& facets) {
              return dielectric_reflectance(std::min(dot(wo, half), 1.0f), eta) * reflected(wo, half, facets);
          });
      })
{
}

FacetTable::FacetTable(float alpha)
    : alpha_(alpha), table_([alpha](float cosine) { return directional_albedo(cosine, alpha, reflected); })
{
}

GlassTable::GlassTable(float eta, float alpha)
    : eta_(eta), alpha_(alpha), outer_(glass_side(eta, alpha)), inner_(glass_side(1 / eta, alpha))
{
    // Reciprocity of the lobes in RoughGlass asks for outer share × outer loss = η² × inner share × inner loss.
    const float ratio = eta * eta * mean_lost(false) / std::max(mean_lost(true), 1e-6f);
    const float mean_reflectance = Skin(eta, kLeastCosine).mean_albedo();
    outer_share_ = std::min(1 - mean_reflectance, ratio);
    inner_share_ = ratio > 0 ? std::min(outer_share_ / ratio, 1.0f) : 0;
}

}  // namespace lumi::baker
