// SPDX-License-Identifier: MIT
#include "material/bsdf.h"

#include "material/lobes.h"

namespace lumi::baker
{
namespace
{

Rgb at_most(const Rgb& c, float most)
{
    return {std::min(c.r, most), std::min(c.g, most), std::min(c.b, most)};
}

// The cosine between a direction and the one halfway to the other.
float facing(const Vec3& wo, const Vec3& half)
{
    return std::min(dot(wo, half), 1.0f);
}

}  // namespace

Rgb Diffuse::eval(const Vec3& wo, const Vec3& wi) const
{
    const float factor = shape_.at(wo, wi, facing(wo, normalized(wo + wi)));
    return at_most(albedo_ * factor, 1) * cosine_pdf(wi);
}

float Diffuse::pdf(const Vec3&, const Vec3& wi) const
{
    return cosine_pdf(wi);
}

std::optional<BsdfSample> Diffuse::sample(const Vec3& wo, float, const Vec2& u) const
{
    const Vec3 wi = square_to_cosine_hemisphere(u);
    if (wi.z <= 0) return std::nullopt;
    const float factor = shape_.at(wo, wi, facing(wo, normalized(wo + wi)));
    return BsdfSample{wi, at_most(albedo_ * factor, 1), cosine_pdf(wi)};
}

template <class Spread>
ConductorOf<Spread>::ConductorOf(const Rgb& f0, const FacetTableOf<Spread>& facets) : f0_(f0), facets_(&facets)
{
    const float lost = facets.mean_lost();
    if (lost > kNegligibleLoss) {
        const Rgb mean = f0 + (grey(1) - f0) * kSchlickMeanWeight;
        broad_ = mean * mean * (1 - lost) / (grey(1) - mean * lost) * (1 / lost);
    }
}

template <class Spread>
float ConductorOf<Spread>::broad_probability(const Vec3& wo) const
{
    return is_black(broad_) ? 0.0f : std::max(0.0f, facets_->lost(wo));
}

template <class Spread>
Rgb ConductorOf<Spread>::eval(const Vec3& wo, const Vec3& wi) const
{
    if (wi.z <= 0) return {};
    const Vec3 half = normalized(wo + wi);
    const float broad = facets_->lost(wo) * facets_->lost(wi) * cosine_pdf(wi);
    return schlick_reflectance(dot(wo, half), f0_) * reflection_value(facets_->facets(), wo, wi, half) + broad_ * broad;
}

template <class Spread>
float ConductorOf<Spread>::pdf(const Vec3& wo, const Vec3& wi) const
{
    const float p = broad_probability(wo);
    return (1 - p) * reflection_pdf(facets_->facets(), wo, wi) + p * cosine_pdf(wi);
}

template <class Spread>
std::optional<BsdfSample> ConductorOf<Spread>::sample(const Vec3& wo, float u_lobe, const Vec2& u) const
{
    const bool broad = u_lobe < broad_probability(wo);
    const Vec3 wi = broad ? square_to_cosine_hemisphere(u) : mirrored(wo, facets_->facets().sample_half(wo, u));
    if (wi.z <= 0) return std::nullopt;
    const float density = pdf(wo, wi);
    return BsdfSample{wi, eval(wo, wi) * (1 / density), density};
}

template <class Spread>
PlasticOf<Spread>::PlasticOf(const Rgb& albedo, const SkinOf<Spread>& skin, const DiffuseShape& shape)
    : skin_(&skin), albedo_(albedo), straight_(1 - dielectric_reflectance(1, skin.eta())), shape_(shape)
{
}

template <class Spread>
Rgb PlasticOf<Spread>::eval(const Vec3& wo, const Vec3& wi) const
{
    if (wi.z <= 0) return {};
    const Vec3 half = normalized(wo + wi);
    const float cosine = facing(wo, half);
    const float reflectance = dielectric_reflectance(cosine, skin_->eta());
    return grey(reflectance * reflection_value(skin_->facets(), wo, wi, half)) +
           body(wo, wi, cosine, reflectance) * cosine_pdf(wi);
}

template <class Spread>
Rgb PlasticOf<Spread>::body(const Vec3& wo, const Vec3& wi, float facing, float reflectance) const
{
    const float coupled = (1 - skin_->albedo(wo)) * (1 - skin_->albedo(wi)) / (1 - skin_->mean_albedo());
    const float mixed = shape_.at(wo, wi, facing) * (1 - reflectance) / straight_;
    return at_most(albedo_ * std::max(mixed, coupled), coupled);
}

template <class Spread>
float PlasticOf<Spread>::skin_probability(const Vec3& wo) const
{
    constexpr float kLeast = 0.1f, kMost = 0.9f;  // both lobes keep a share, so that no bright path becomes rare
    const float skin = skin_->albedo(wo);
    const float body = std::min(max_component(albedo_), 1 - skin);
    return std::clamp(skin / (skin + body), kLeast, kMost);
}

template <class Spread>
float PlasticOf<Spread>::pdf(const Vec3& wo, const Vec3& wi) const
{
    const float p = skin_probability(wo);
    return p * reflection_pdf(skin_->facets(), wo, wi) + (1 - p) * cosine_pdf(wi);
}

template <class Spread>
std::optional<BsdfSample> PlasticOf<Spread>::sample(const Vec3& wo, float u_lobe, const Vec2& u) const
{
    const bool skin = u_lobe < skin_probability(wo);
    const Vec3 wi = skin ? mirrored(wo, skin_->facets().sample_half(wo, u)) : square_to_cosine_hemisphere(u);
    if (wi.z <= 0) return std::nullopt;
    const float density = pdf(wo, wi);
    return BsdfSample{wi, eval(wo, wi) * (1 / density), density};
}

template class ConductorOf<Isotropic>;
template class ConductorOf<Anisotropic>;
template class PlasticOf<Isotropic>;
template class PlasticOf<Anisotropic>;

}  // namespace lumi::baker
