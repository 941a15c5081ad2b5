// SPDX-License-Identifier: MIT
// Scattering at a surface point, in the local frame whose z is the shading normal on the side of the viewer.
//
// Protocol: wo points to the viewer (wo.z > 0), wi to the light. eval() is f·|cos θi| and 0 where nothing scatters;
// pdf() is the solid-angle density of sample(); sample() returns a direction with its weight eval/pdf, or nothing when
// the light is lost. A further kind of surface is one more alternative of the variant; transmission is a wi with z < 0.
#pragma once

#include <optional>
#include <variant>

#include "skin.h"
#include "vec3.h"

namespace lumi::baker
{

struct BsdfSample {
    Vec3 wi;
    Rgb weight;
    float pdf;
};

class Diffuse
{
public:
    explicit Diffuse(const Rgb& albedo) : albedo_(albedo) {}
    Rgb eval(const Vec3& wo, const Vec3& wi) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    std::optional<BsdfSample> sample(const Vec3& wo, float u_lobe, const Vec2& u) const;

private:
    Rgb albedo_;
};

// GGX metal with Schlick's Fresnel term. Light that bounces between facets more than once is lost.
class Conductor
{
public:
    Conductor(const Rgb& f0, float alpha) : f0_(f0), alpha_(alpha) {}
    Rgb eval(const Vec3& wo, const Vec3& wi) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    std::optional<BsdfSample> sample(const Vec3& wo, float u_lobe, const Vec2& u) const;

private:
    Rgb f0_;
    float alpha_;
};

// A diffuse body under a rough dielectric skin: the light that the skin does not reflect is diffused, and what it
// throws back inside is diffused again (a geometric series). A white body loses nothing.
class Plastic
{
public:
    Plastic(const Rgb& albedo, const Skin& skin);  // borrows the skin
    Rgb eval(const Vec3& wo, const Vec3& wi) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    std::optional<BsdfSample> sample(const Vec3& wo, float u_lobe, const Vec2& u) const;

private:
    float skin_probability(float cosine) const;

    const Skin* skin_;
    Rgb body_;  // albedo of the body seen through the skin, before the two crossings
};

class Bsdf
{
public:
    template <class Kind>
    explicit Bsdf(const Kind& kind) : kind_(kind)
    {
    }

    Rgb eval(const Vec3& wo, const Vec3& wi) const
    {
        return std::visit([&](const auto& kind) { return kind.eval(wo, wi); }, kind_);
    }
    float pdf(const Vec3& wo, const Vec3& wi) const
    {
        return std::visit([&](const auto& kind) { return kind.pdf(wo, wi); }, kind_);
    }
    std::optional<BsdfSample> sample(const Vec3& wo, float u_lobe, const Vec2& u) const
    {
        return std::visit([&](const auto& kind) { return kind.sample(wo, u_lobe, u); }, kind_);
    }

private:
    std::variant<Diffuse, Conductor, Plastic> kind_;
};

}  // namespace lumi::baker
