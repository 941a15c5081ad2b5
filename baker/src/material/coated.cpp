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

float Coated::skin_probability(const Vec3& wo) const
{
    constexpr float kLeast = 0.1f, kMost = 0.9f;
    return std::clamp(coverage_ * coat_->albedo(wo.z), kLeast, kMost);
}

float Coated::pdf(const Vec3& wo, const Vec3& wi) const
{
    const float p = skin_probability(wo);
    const float body = std::visit([&](const auto& b) { return b.pdf(wo, wi); }, body_);
    return p * reflection_pdf(coat_->facets(), wo, wi) + (1 - p) * body;
}

std::optional<BsdfSample> Coated::sample(const Vec3& wo, float u_lobe, const Vec2& u) const
{
    const float p = skin_probability(wo);
    const std::optional<Vec3> wi = u_lobe < p ? mirrored(wo, coat_->facets().sample_half(wo, u))
                                              : body_direction(body_, wo, (u_lobe - p) / (1 - p), u);
    if (!wi || wi->z <= 0) return std::nullopt;
    const float density = pdf(wo, *wi);
    return BsdfSample{*wi, eval(wo, *wi) * (1 / density), density};
}

namespace
{

constexpr float kUniformPdf = 1 / (2 * kPi);

// Fibres are so broad a lobe that uniform directions serve it well (Estevez & Kulla 2017). The z is above 0.
Vec3 square_to_hemisphere(const Vec2& u)
{
    return direction_at(1 - u.x, u.y);
}

}  // namespace

Sheened::Sheened(const Body& body, const SheenTable& fibres, const Rgb& colour)
    : body_(body), fibres_(&fibres), colour_(colour), strength_(max_component(colour))
{
}

// The share of light between two directions that passes the fibres both ways.
float Sheened::below(const Vec3& wo, const Vec3& wi) const
{
    const float o = strength_ * fibres_->albedo(wo), i = strength_ * fibres_->albedo(wi);
    if (std::holds_alternative<Diffuse>(body_)) return (1 - o) * (1 - i) / (1 - strength_ * fibres_->mean_albedo());
    return 1 - std::max(o, i);
}

Rgb Sheened::eval(const Vec3& wo, const Vec3& wi) const
{
    if (wi.z <= 0) return {};
    const Rgb body = std::visit([&](const auto& b) { return b.eval(wo, wi); }, body_);
    return colour_ * fibres_->value(wo, wi) + body * below(wo, wi);
}

float Sheened::fibre_probability(const Vec3& wo) const
{
    constexpr float kLeast = 0.1f, kMost = 0.9f;
    return std::clamp(strength_ * fibres_->albedo(wo), kLeast, kMost);
}

float Sheened::pdf(const Vec3& wo, const Vec3& wi) const
{
    if (wi.z <= 0) return 0;
    const float p = fibre_probability(wo);
    const float body = std::visit([&](const auto& b) { return b.pdf(wo, wi); }, body_);
    return p * kUniformPdf + (1 - p) * body;
}

std::optional<BsdfSample> Sheened::sample(const Vec3& wo, float u_lobe, const Vec2& u) const
{
    const float p = fibre_probability(wo);
    const std::optional<Vec3> wi =
        u_lobe < p ? square_to_hemisphere(u) : body_direction(body_, wo, (u_lobe - p) / (1 - p), u);
    const float density = wi ? pdf(wo, *wi) : 0;
    if (!(density > 0)) return std::nullopt;
    return BsdfSample{*wi, eval(wo, *wi) * (1 / density), density};
}

}  // namespace lumi::baker
