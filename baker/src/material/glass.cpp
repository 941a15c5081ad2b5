// SPDX-License-Identifier: MIT
#include <limits>

#include "material/bsdf.h"
#include "material/lobes.h"

namespace lumi::baker
{
namespace
{

// A refraction from wo to wi through the facet `half`; the Jacobian of half against wi is η²|wi·h| / denominator.
struct Crossing {
    Vec3 half;
    float facing, beyond, denominator;  // wo·h > 0, |wi·h|
    bool possible;
};

Crossing crossing(const Vec3& wo, const Vec3& wi, float eta)
{
    const Vec3 sum = wo + wi * eta;
    Vec3 half = normalized(sum);
    half = half.z < 0 ? -half : half;
    const float facing = dot(wo, half), behind = dot(wi, half);
    const float root = facing + eta * behind;
    return {half, facing, -behind, root * root, facing > 0 && behind < 0 && root != 0};
}

}  // namespace

std::optional<BsdfSample> SmoothGlass::sample(const Vec3& wo, float u_lobe, const Vec2&) const
{
    constexpr float kCertain = std::numeric_limits<float>::infinity();
    const Vec3 normal = {0, 0, 1};
    if (u_lobe < dielectric_reflectance(std::min(wo.z, 1.0f), eta_))
        return BsdfSample{mirrored(wo, normal), grey(1), kCertain};
    return BsdfSample{refracted(wo, normal, eta_), grey(1 / (eta_ * eta_)), kCertain};
}

// Share of the broad lobes on wi's side.
float RoughGlass::side_share(const Vec3& wi) const
{
    const float through = table_->transmitted_share(outside_);
    return wi.z > 0 ? 1 - through : through;
}

float RoughGlass::broad_probability(float cosine) const
{
    const bool negligible = std::min(table_->mean_lost(true), table_->mean_lost(false)) < kNegligibleLoss;
    return negligible ? 0.0f : std::max(0.0f, table_->lost(outside_, cosine));
}

float RoughGlass::broad_value(const Vec3& wo, const Vec3& wi) const
{
    const float first = broad_probability(wo.z);
    if (first <= 0) return 0;
    const bool there = wi.z > 0 ? outside_ : !outside_;
    const float radiance = wi.z > 0 ? 1 : 1 / (eta() * eta());
    const float second = table_->lost(there, std::abs(wi.z)) / table_->mean_lost(there);
    return radiance * side_share(wi) * first * second * std::abs(wi.z) * kInvPi;
}

Rgb RoughGlass::eval(const Vec3& wo, const Vec3& wi) const
{
    const Ggx facets(table_->alpha());
    float single = 0;
    if (wi.z > 0) {
        const Vec3 half = normalized(wo + wi);
        single = dielectric_reflectance(std::min(dot(wo, half), 1.0f), eta()) * reflection_value(facets, wo, wi, half);
    } else if (const Crossing c = crossing(wo, wi, eta()); c.possible) {
        const float through = 1 - dielectric_reflectance(std::min(c.facing, 1.0f), eta());
        single = c.facing * c.beyond * through * facets.masking_shadowing(wo, wi) * facets.density(c.half) /
                 (wo.z * c.denominator);
    }
    return grey(single + broad_value(wo, wi));
}

float RoughGlass::pdf(const Vec3& wo, const Vec3& wi) const
{
    const Ggx facets(table_->alpha());
    float single = 0;
    if (wi.z > 0) {
        const Vec3 half = normalized(wo + wi);
        single = dielectric_reflectance(std::min(dot(wo, half), 1.0f), eta()) * reflection_pdf(facets, wo, wi);
    } else if (const Crossing c = crossing(wo, wi, eta()); c.possible) {
        const float through = 1 - dielectric_reflectance(std::min(c.facing, 1.0f), eta());
        single = through * facets.pdf_half(wo, c.half) * eta() * eta() * c.beyond / c.denominator;
    }
    const float p = broad_probability(wo.z);
    return (1 - p) * single + p * side_share(wi) * std::abs(wi.z) * kInvPi;
}

std::optional<BsdfSample> RoughGlass::sample(const Vec3& wo, float u_lobe, const Vec2& u) const
{
    const float p = broad_probability(wo.z);
    const bool broad = u_lobe < p;
    const float rest = broad ? u_lobe / p : (u_lobe - p) / (1 - p);
    bool through;
    Vec3 wi;
    if (broad) {
        through = rest < table_->transmitted_share(outside_);
        wi = square_to_cosine_hemisphere(u);
        wi.z = through ? -wi.z : wi.z;
    } else {
        const Vec3 half = Ggx(table_->alpha()).sample_half(wo, u);
        through = rest >= dielectric_reflectance(std::min(dot(wo, half), 1.0f), eta());
        wi = through ? refracted(wo, half, eta()) : mirrored(wo, half);
    }
    if (through ? wi.z >= 0 : wi.z <= 0) return std::nullopt;
    const float density = pdf(wo, wi);
    if (!(density > 0)) return std::nullopt;
    return BsdfSample{wi, eval(wo, wi) * (1 / density), density};
}

}  // namespace lumi::baker
