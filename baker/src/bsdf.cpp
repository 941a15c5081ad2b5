// SPDX-License-Identifier: MIT
#include "bsdf.h"

#include "fresnel.h"
#include "microfacet.h"

namespace lumi::baker
{
namespace
{

constexpr float kInvPi = 1 / kPi;

float cosine_pdf(const Vec3& wi)
{
    return wi.z > 0 ? wi.z * kInvPi : 0.0f;
}

// Density of the mirror direction of a sampled facet.
float reflection_pdf(const Ggx& facets, const Vec3& wo, const Vec3& wi)
{
    if (wi.z <= 0) {
        return 0;
    }
    const Vec3 half = normalized(wo + wi);
    return facets.pdf_half(wo, half) / (4 * std::max(dot(wo, half), 1e-7f));
}

// Torrance-Sparrow reflection times cos θi, without the Fresnel factor.
float reflection_value(const Ggx& facets, const Vec3& wo, const Vec3& wi, const Vec3& half)
{
    return facets.density(half) * facets.masking_shadowing(wo, wi) / (4 * wo.z);
}

Vec3 mirrored(const Vec3& wo, const Vec3& half)
{
    return half * (2 * dot(wo, half)) - wo;
}

}  // namespace

Rgb Diffuse::eval(const Vec3&, const Vec3& wi) const
{
    return albedo_ * cosine_pdf(wi);
}

float Diffuse::pdf(const Vec3&, const Vec3& wi) const
{
    return cosine_pdf(wi);
}

std::optional<BsdfSample> Diffuse::sample(const Vec3&, float, const Vec2& u) const
{
    const Vec3 wi = square_to_cosine_hemisphere(u);
    if (wi.z <= 0) {
        return std::nullopt;
    }
    return BsdfSample{wi, albedo_, cosine_pdf(wi)};
}

Rgb Conductor::eval(const Vec3& wo, const Vec3& wi) const
{
    if (wi.z <= 0) {
        return {};
    }
    const Vec3 half = normalized(wo + wi);
    return schlick_reflectance(dot(wo, half), f0_) * reflection_value(Ggx(alpha_), wo, wi, half);
}

float Conductor::pdf(const Vec3& wo, const Vec3& wi) const
{
    return reflection_pdf(Ggx(alpha_), wo, wi);
}

std::optional<BsdfSample> Conductor::sample(const Vec3& wo, float, const Vec2& u) const
{
    const Ggx facets(alpha_);
    const Vec3 half = facets.sample_half(wo, u);
    const Vec3 wi = mirrored(wo, half);
    if (wi.z <= 0) {
        return std::nullopt;
    }
    const float shadowing = facets.masking_shadowing(wo, wi) / facets.masking(wo);
    return BsdfSample{wi, schlick_reflectance(dot(wo, half), f0_) * shadowing, reflection_pdf(facets, wo, wi)};
}

Plastic::Plastic(const Rgb& albedo, const Skin& skin) : skin_(&skin)
{
    // Reflectance seen from inside, from the reciprocity of the two crossings.
    const float eta2 = skin.eta() * skin.eta();
    const float inner = 1 - (1 - skin.mean_albedo()) / eta2;
    body_ = albedo / (grey(1) - albedo * inner) * (1 / eta2);
}

Rgb Plastic::eval(const Vec3& wo, const Vec3& wi) const
{
    if (wi.z <= 0) {
        return {};
    }
    const Vec3 half = normalized(wo + wi);
    const float reflected = dielectric_reflectance(std::min(dot(wo, half), 1.0f), skin_->eta()) *
                            reflection_value(Ggx(skin_->alpha()), wo, wi, half);
    const float crossings = (1 - skin_->albedo(wo.z)) * (1 - skin_->albedo(wi.z));
    return grey(reflected) + body_ * (crossings * cosine_pdf(wi));
}

float Plastic::skin_probability(float cosine) const
{
    constexpr float kLeast = 0.1f, kMost = 0.9f;  // both lobes keep a share, so that no bright path becomes rare
    const float skin = skin_->albedo(cosine);
    const float body = (1 - skin) * (1 - skin_->mean_albedo()) * max_component(body_);
    return std::clamp(skin / (skin + body), kLeast, kMost);
}

float Plastic::pdf(const Vec3& wo, const Vec3& wi) const
{
    const float p = skin_probability(wo.z);
    return p * reflection_pdf(Ggx(skin_->alpha()), wo, wi) + (1 - p) * cosine_pdf(wi);
}

std::optional<BsdfSample> Plastic::sample(const Vec3& wo, float u_lobe, const Vec2& u) const
{
    const bool skin = u_lobe < skin_probability(wo.z);
    const Vec3 wi = skin ? mirrored(wo, Ggx(skin_->alpha()).sample_half(wo, u)) : square_to_cosine_hemisphere(u);
    if (wi.z <= 0) {
        return std::nullopt;
    }
    const float density = pdf(wo, wi);
    return BsdfSample{wi, eval(wo, wi) * (1 / density), density};
}

}  // namespace lumi::baker
