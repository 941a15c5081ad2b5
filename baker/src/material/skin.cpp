// SPDX-License-Identifier: MIT
#include "material/skin.h"

#include "material/lobes.h"
#include "util/fuzzed.h"

namespace lumi::baker
{
namespace
{

// Samples for one direction: they are a Fibonacci lattice, whose steps are neighbouring Fibonacci numbers.
constexpr int kSamples = kIsFuzzed ? 13 : 610, kStep = kIsFuzzed ? 8 : 377;

// Mean of weight(wo, half, facets) over samples of visible facets.
template <class Spread, class Weight>
float directional_albedo(const Vec3& wo, const GgxOf<Spread>& facets, const Weight& weight)
{
    float sum = 0;
    for (int k = 0; k < kSamples; ++k) {
        const Vec2 u = {(static_cast<float>(k) + 0.5f) / kSamples,
                        (static_cast<float>(k * kStep % kSamples) + 0.5f) / kSamples};
        sum += weight(wo, facets.sample_half(wo, u), facets);
    }
    return std::min(sum / kSamples, 1.0f);
}

template <class Weight>
AlbedoTable table_of(const Isotropic& spread, const Weight& weight)
{
    return AlbedoTable([&](float cosine) { return directional_albedo(direction_at(cosine, 0), Ggx(spread), weight); });
}

template <class Weight>
AnisotropicAlbedo table_of(const Anisotropic& spread, const Weight& weight)
{
    const GgxOf<Anisotropic> facets(spread);
    return AnisotropicAlbedo(spread, [&](const Vec3& wo) { return directional_albedo(wo, facets, weight); });
}

// The light that a sampled facet reflects or refracts, without the Fresnel factor.
template <class Facets>
float passed_on(const Vec3& wo, const Vec3& wi, const Facets& facets)
{
    return facets.masking_shadowing(wo, wi) / facets.masking(wo);
}

template <class Facets>
float reflected(const Vec3& wo, const Vec3& half, const Facets& facets)
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
    return table_of(
        Isotropic(alpha),
        [eta](const Vec3& wo, const Vec3& half, const Ggx& facets) {
            const float f = dielectric_reflectance(std::min(dot(wo, half), 1.0f), eta);
            return f * reflected(wo, half, facets) + (f < 1 ? (1 - f) * transmitted(wo, half, facets, eta) : 0);
        });
}

}  // namespace

template <class Spread>
SkinOf<Spread>::SkinOf(float eta, const Spread& spread)
    : eta_(eta), facets_(spread), table_(table_of(spread, [eta](const Vec3& wo, const Vec3& half, const auto& facets) {
          return dielectric_reflectance(std::min(dot(wo, half), 1.0f), eta) * reflected(wo, half, facets);
      }))
{
}

template <class Spread>
FacetTableOf<Spread>::FacetTableOf(const Spread& spread)
    : facets_(spread), table_(table_of(spread, reflected<GgxOf<Spread>>))
{
}

template SkinOf<Isotropic>::SkinOf(float, const Isotropic&);
template SkinOf<Anisotropic>::SkinOf(float, const Anisotropic&);
template FacetTableOf<Isotropic>::FacetTableOf(const Isotropic&);
template FacetTableOf<Anisotropic>::FacetTableOf(const Anisotropic&);

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
