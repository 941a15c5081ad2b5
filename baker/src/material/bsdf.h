// SPDX-License-Identifier: MIT
// Scattering at a surface point, in the local frame whose z is the shading normal on the side of the viewer.
//
// Protocol: wo points to the viewer (wo.z > 0), wi to the light. eval() is f·|cos θi| and 0 where nothing scatters;
// pdf() is the solid-angle density of sample(); sample() returns a direction with its weight eval/pdf, or nothing when
// the light is lost. An infinite pdf marks a direction that has a probability of its own (a mirror's): eval() and pdf()
// know nothing of it. A further kind of surface is one more alternative of the variant; transmission is a wi with z <
// 0, and its weight holds the change of radiance by the square of the relative index.
#pragma once

#include <optional>
#include <variant>

#include "material/sheen.h"
#include "material/skin.h"
#include "math/vec3.h"

namespace lumi::baker
{

// How the light that leaves a diffuse body spreads over directions, as a factor to the even spread of Lambert's law.
//
// A body of known roughness has Burley's shape: a smooth one darkens towards the horizon, a rough one sends light back
// to where it came from. Burley, "Physically Based Shading at Disney", SIGGRAPH 2012 course, section 5.3; the
// Principled shader of Blender has it. It is symmetric in the two directions. Its mean is 0.95 for roughness 0, 1.0 for
// 0.5, and 1.07 for 1.

class DiffuseShape
{
public:
    DiffuseShape() = default;  // Lambert's
    // `roughness` lies in [0, 1].
    explicit DiffuseShape(float roughness) : roughness_(roughness), rough_(true) {}

    // `facing` is the cosine between a direction and the one halfway to the other.
    float at(const Vec3& wo, const Vec3& wi, float facing) const
    {
        if (!rough_) return 1;
        const float grazing = 2 * roughness_ * facing * facing - 0.5f;  // the horizon gains this
        return (1 + grazing * fifth_power(1 - wo.z)) * (1 + grazing * fifth_power(1 - wi.z));
    }

private:
    static float fifth_power(float x) { return x * x * x * x * x; }

    float roughness_ = 0;
    bool rough_ = false;
};

struct BsdfSample {
    Vec3 wi;
    Rgb weight;
    float pdf;
};

// A diffuse body, which in no pair of directions sends back more than a white one of Lambert's shape.
class Diffuse
{
public:
    explicit Diffuse(const Rgb& albedo, const DiffuseShape& shape = {}) : albedo_(albedo), shape_(shape) {}
    Rgb eval(const Vec3& wo, const Vec3& wi) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    std::optional<BsdfSample> sample(const Vec3& wo, float u_lobe, const Vec2& u) const;

private:
    Rgb albedo_;
    DiffuseShape shape_;
};

// GGX metal with Schlick's Fresnel term. Light that bounces between facets more than once leaves in a second, broad
// lobe (Kulla & Conty 2017): white metal loses nothing.
template <class Spread>
class ConductorOf
{
public:
    ConductorOf(const Rgb& f0, const FacetTableOf<Spread>& facets);  // borrows the facets
    Rgb eval(const Vec3& wo, const Vec3& wi) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    std::optional<BsdfSample> sample(const Vec3& wo, float u_lobe, const Vec2& u) const;

private:
    float broad_probability(const Vec3& wo) const;

    Rgb f0_, broad_;  // broad_: colour of the second lobe over what one bounce loses on average
    const FacetTableOf<Spread>* facets_;
};

// A dielectric over a diffuse body, as glTF 2.0 mixes the two (B.2.2 "Dielectrics" and B.3.4 "Fresnel"): a facet
// reflects by its Fresnel term, and the body gets the rest. The albedo is what the body shows through the skin from
// straight above, so that gloss does not darken a colour: glTF's base colour times 1 - F0 is that albedo.
//
// That mix alone is not energy-conserving (B.3.6.3 "Coupling Diffuse and Specular Reflection"): where light grazes,
// more is sent back than arrives. So a white body is coupled to the skin as that section names (Kulla & Conty
// 2017): the two together lose nothing. A coloured body sends back its share of the brighter of mix and coupling, and
// never more than a white one. All of it is symmetric in the two directions.
template <class Spread>
class PlasticOf
{
public:
    PlasticOf(const Rgb& albedo, const SkinOf<Spread>& skin, const DiffuseShape& shape = {});  // borrows the skin
    Rgb eval(const Vec3& wo, const Vec3& wi) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    std::optional<BsdfSample> sample(const Vec3& wo, float u_lobe, const Vec2& u) const;
    float skin_probability(const Vec3& wo) const;

private:
    Rgb body(const Vec3& wo, const Vec3& wi, float facing, float reflectance) const;

    const SkinOf<Spread>* skin_;
    Rgb albedo_;
    float straight_;  // a facet lets this in from straight above
    DiffuseShape shape_;
};

// Brushed surfaces: x of the local frame is the direction of alpha_x.
using Conductor = ConductorOf<Isotropic>;
using BrushedConductor = ConductorOf<Anisotropic>;
using Plastic = PlasticOf<Isotropic>;
using BrushedPlastic = PlasticOf<Anisotropic>;

// A clear coat over an opaque surface. Below it goes on what the coat does not reflect towards either direction, so
// that the two together never gain and lose at most the coat's mean reflectance.
class Coated
{
public:
    using Body = std::variant<Diffuse, Conductor, Plastic, BrushedConductor, BrushedPlastic>;

    // coverage in [0, 1]: how much of the surface the coat covers. Borrows the coat.
    Coated(const Body& body, const Skin& coat, float coverage) : body_(body), coat_(&coat), coverage_(coverage) {}
    Rgb eval(const Vec3& wo, const Vec3& wi) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    std::optional<BsdfSample> sample(const Vec3& wo, float u_lobe, const Vec2& u) const;
    float skin_probability(const Vec3& wo) const;

private:
    Body body_;
    const Skin* coat_;
    float coverage_;
};

// Fibres on an opaque surface, above its coat if it has one. What they do not send back goes on below: over a matt
// surface exactly (Kulla & Conty 2017), over any other as under a coat, never more than there is.
class Sheened
{
public:
    using Body = std::variant<Diffuse, Conductor, Plastic, BrushedConductor, BrushedPlastic, Coated>;

    // colour in [0, 1]: of the fibres, times their share of the surface. Borrows the fibres.
    Sheened(const Body& body, const SheenTable& fibres, const Rgb& colour);
    Rgb eval(const Vec3& wo, const Vec3& wi) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    std::optional<BsdfSample> sample(const Vec3& wo, float u_lobe, const Vec2& u) const;

private:
    float below(const Vec3& wo, const Vec3& wi) const;
    float fibre_probability(const Vec3& wo) const;

    Body body_;
    const SheenTable* fibres_;
    Rgb colour_;
    float strength_;  // the colour's largest component
};

// This is a polished boundary between two clear media.
class SmoothGlass
{
public:
    // `eta` is the index of the far side relative to the viewer's.
    explicit SmoothGlass(float eta) : eta_(eta) {}
    Rgb eval(const Vec3&, const Vec3&) const { return {}; }
    float pdf(const Vec3&, const Vec3&) const { return 0; }
    std::optional<BsdfSample> sample(const Vec3& wo, float u_lobe, const Vec2& u) const;

private:
    float eta_;
};

// A frosted boundary: Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007; light of
// more than one bounce leaves in broad lobes to both sides.
class RoughGlass
{
public:
    RoughGlass(const GlassTable& table, bool outside) : table_(&table), outside_(outside) {}  // borrows the table
    Rgb eval(const Vec3& wo, const Vec3& wi) const;
    float pdf(const Vec3& wo, const Vec3& wi) const;
    std::optional<BsdfSample> sample(const Vec3& wo, float u_lobe, const Vec2& u) const;

private:
    float eta() const { return outside_ ? table_->eta() : 1 / table_->eta(); }
    float broad_value(const Vec3& wo, const Vec3& wi) const;
    float broad_probability(float cosine) const;
    float side_share(const Vec3& wi) const;

    const GlassTable* table_;
    bool outside_;  // where the viewer is
};

class Bsdf
{
public:
    template <class Kind>
    explicit Bsdf(const Kind& kind) : kind_(kind)
    {
    }

    // Whether light may enter by it.
    bool is_glass() const
    {
        return std::holds_alternative<SmoothGlass>(kind_) || std::holds_alternative<RoughGlass>(kind_);
    }
    // Whether sample() looks at u_lobe.
    bool has_lobes() const { return !std::holds_alternative<Diffuse>(kind_); }
    // sample() takes its skin or coat for smaller u_lobe, and what lies below for others; 0 where it has neither.
    float skin_probability(const Vec3& wo) const
    {
        return std::visit([&](const auto& kind) { return probability_of_skin(kind, wo, 0); }, kind_);
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
    template <class Kind>
    static auto probability_of_skin(const Kind& kind, const Vec3& wo, int) -> decltype(kind.skin_probability(wo))
    {
        return kind.skin_probability(wo);
    }
    template <class Kind>
    static float probability_of_skin(const Kind&, const Vec3&, long)
    {
        return 0;
    }

    std::variant<Diffuse, Conductor, Plastic, Coated, SmoothGlass, RoughGlass, BrushedConductor, BrushedPlastic,
                 Sheened>
        kind_;
};

}  // namespace lumi::baker
