// SPDX-License-Identifier: MIT
#include "material/bsdf.h"
#include "material/lobes.h"

namespace lumi::baker
{

Rgb Coated::eval(const Vec3& wo, const Vec3& wi) const
{
    if (wi.z <= 0) return {};
    const Vec3 half = normalized(wo + wi);
    const float reflected = dielectric_reflectance(std::min(dot(wo, half), 1.0f), coat_->eta()) *
                            reflection_value(coat_->facets(), wo, wi, half);
    const float below = 1 - coverage_ * std::max(coat_->albedo(wo.z), coat_->albedo(wi.z));
    const Rgb body = std::visit([&](const auto& b) { return b.eval(wo, wi); }, body_);
    return grey(coverage_ * reflected) + body * below;
}

float Coated::coat_probability(float cosine) const
{
    constexpr float kLeast = 0.1f, kMost = 0.9f;
    return std::clamp(coverage_ * coat_->albedo(cosine), kLeast, kMost);
}

float Coated::pdf(const Vec3& wo, const Vec3& wi) const
{
    const float p = coat_probability(wo.z);
    const float body = std::visit([&](const auto& b) { return b.pdf(wo, wi); }, body_);
    return p * reflection_pdf(coat_->facets(), wo, wi) + (1 - p) * body;
}

std::optional<BsdfSample> Coated::sample(const Vec3& wo, float u_lobe, const Vec2& u) const
{
    const float p = coat_probability(wo.z);
    const std::optional<Vec3> wi = u_lobe < p ? mirrored(wo, coat_->facets().sample_half(wo, u))
                                              : body_direction(body_, wo, (u_lobe - p) / (1 - p), u);
    if (!wi || wi->z <= 0) return std::nullopt;
    const float density = pdf(wo, *wi);
    return BsdfSample{*wi, eval(wo, *wi) * (1 / density), density};
}

}  // namespace lumi::baker
