// SPDX-License-Identifier: MIT
#include "material/bsdf.h"

#include <catch2/catch.hpp>
#include <limits>
#include <map>

#include "material/lobes.h"
#include "material/material.h"
#include "math/warp.h"
#include "support/bsdf_checks.h"

namespace lumi::baker
{
namespace
{

using testing::kQuadrature;
using testing::Named;
using testing::plain_values;
using testing::short_text;
using testing::views;

constexpr float kSkinIndex = 1.5f;
const Skin& skin(float alpha)
{
    static std::map<float, Skin> skins;  // a Plastic borrows its skin
    return skins.try_emplace(alpha, kSkinIndex, alpha).first->second;
}

Plastic plastic(float albedo, float alpha)
{
    return Plastic(grey(albedo), skin(alpha));
}

Plastic rough_plastic(float albedo, float roughness)
{
    return Plastic(grey(albedo), skin(alpha_from_roughness(roughness)), DiffuseShape(roughness));
}

// Bodies of Burley's shape, bare and under a skin of the same roughness.
std::vector<Named> rough_bodies(float albedo, const std::vector<float>& roughnesses = {0.2f, 0.5f, 1.0f})
{
    std::vector<Named> all;
    for (const float roughness : roughnesses) {
        all.push_back({"rough diffuse " + short_text(roughness), Bsdf(Diffuse(grey(albedo), DiffuseShape(roughness)))});
        all.push_back({"rough plastic " + short_text(roughness), Bsdf(rough_plastic(albedo, roughness))});
    }
    return all;
}

// Integrates eval over the directions of light by the midpoint rule, for materials that reflect alike in all azimuths.
double albedo_by_grid(const Bsdf& bsdf, const Vec3& wo)
{
    constexpr int kHeights = 400, kTurns = 400;
    double sum = 0;
    for (int h = 0; h < kHeights; ++h) {
        for (int t = 0; t < kTurns; ++t) {
            const float turns = (static_cast<float>(t) + 0.5f) / kTurns;
            sum += static_cast<double>(bsdf.eval(wo, direction_at((static_cast<float>(h) + 0.5f) / kHeights, turns)).g);
        }
    }
    return sum * 2 * static_cast<double>(kPi) / kHeights / kTurns;
}

Conductor conductor(float f0, float alpha)
{
    static std::map<float, FacetTable> tables;  // a Conductor borrows its facets
    return Conductor(grey(f0), tables.try_emplace(alpha, alpha).first->second);
}

std::vector<Named> white_bsdfs()
{
    std::vector<Named> all = {{"diffuse", Bsdf(Diffuse(grey(1)))}};
    for (const float alpha : {0.01f, 0.05f, 0.2f, 0.5f, 1.0f}) {
        all.push_back({"conductor " + short_text(alpha), Bsdf(conductor(1, alpha))});
        all.push_back({"plastic " + short_text(alpha), Bsdf(plastic(1, alpha))});
    }
    return all;
}

}  // namespace

// Narrow lobes need more than a grid can give; they share every line of code with the wide ones.
TEST_CASE("bsdf: pdf integrates to one minus the samples that are lost, and samples follow it")
{
    std::vector<Named> all = {{"diffuse", Bsdf(Diffuse(grey(0.5f)))}};
    for (const float alpha : {0.2f, 0.5f, 1.0f}) {
        all.push_back({"conductor " + short_text(alpha), Bsdf(conductor(0.8f, alpha))});
        all.push_back({"plastic " + short_text(alpha), Bsdf(plastic(0.3f, alpha))});
    }
    for (const Named& named : rough_bodies(0.3f, {0.5f, 1.0f})) all.push_back(named);
    for (const Named& named : all) check_density(named, views());
}

TEST_CASE("bsdf: a sample's weight and pdf are those of its direction")
{
    for (const Named& named : white_bsdfs()) check_weights(named, views());
    for (const float albedo : {0.3f, 1.0f})
        for (const Named& named : rough_bodies(albedo)) check_weights(named, views());
}

TEST_CASE("bsdf: reciprocal")
{
    for (const Named& named : white_bsdfs()) check_reciprocal(named);
    for (const float albedo : {0.3f, 0.9f, 1.0f})
        for (const Named& named : rough_bodies(albedo)) check_reciprocal(named);
}

TEST_CASE("bsdf: a white furnace neither gains nor loses energy")
{
    std::map<std::string, double> losses;
    for (const Named& named : white_bsdfs()) losses[named.name] = checked_loss(named, views());
    CHECK(losses["diffuse"] < 1e-6);
    for (const char* alpha : {"0.01", "0.05", "0.2", "0.5", "1.0"}) {
        INFO("plastic " << alpha);
        CHECK(losses[std::string("plastic ") + alpha] < 0.01);
    }
    for (const char* alpha : {"0.01", "0.05", "0.2", "0.5", "1.0"}) {
        INFO("conductor " << alpha);
        CHECK(losses[std::string("conductor ") + alpha] < 0.01);
    }
}

// Burley's shape is not white: a bare body of roughness 0.2 keeps up to a quarter where it is seen from the side.
TEST_CASE("bsdf: rough bodies gain nothing in a white furnace")
{
    constexpr double kSmoothBodyLoses = 0.25;
    for (const Named& named : rough_bodies(1)) {
        const double loss = checked_loss(named, views());
        INFO(named.name << " loses " << loss);
        CHECK(loss < (named.name.find("plastic") != std::string::npos ? 0.01 : kSmoothBodyLoses));
    }
}

// glTF 2.0, appendix B: mix(diffuse, specular, F), with the diffuse share normalised to what is let in from straight
// above. Dark bodies are never bounded by what a white one sends back.
TEST_CASE("bsdf: a dark plastic is glTF's mix of its body and its skin by the Fresnel term")
{
    constexpr float kAlbedo = 0.05f, kAlpha = 0.25f, kF0 = 0.04f;
    const Skin& s = skin(kAlpha);
    double worst = 0;
    for (const Vec3& wo : views()) {
        for (const Vec3& wi : views(0.4f)) {
            const Vec3 half = normalized(wo + wi);
            const float f = dielectric_reflectance(dot(wo, half), kSkinIndex);
            const float layer = s.facets().density(half) * s.facets().masking_shadowing(wo, wi) / (4 * wo.z);
            const float base = kAlbedo / (1 - kF0) * wi.z / kPi;
            const double ours = static_cast<double>(plastic(kAlbedo, kAlpha).eval(wo, wi).g);
            worst = std::max(worst, std::abs(ours / static_cast<double>(base * (1 - f) + layer * f) - 1));
        }
    }
    INFO("worst difference " << worst);
    CHECK(worst < 0.02);  // where white plastic sends back more than the mix does: at most 1.6 % of a body of 5 %
}

TEST_CASE("bsdf: gloss does not darken the colour of a body that is seen from above")
{
    for (const float albedo : {0.05f, 0.5f, 0.8f}) {
        const double all = albedo_by_grid(Bsdf(plastic(albedo, 0.5f)), {0, 0, 1});
        const double body = all - static_cast<double>(skin(0.5f).albedo(1));
        INFO("albedo " << albedo << ": the body sends back " << body);
        CHECK(body == Approx(static_cast<double>(albedo)).epsilon(0.015));
    }
}

TEST_CASE("bsdf: a body's shape is even at normal incidence and has Burley's values at the horizon")
{
    const Vec3 up = {0, 0, 1}, level = {1, 0, 0}, back = {-1, 0, 0};
    for (const float roughness : {0.0f, 0.5f, 1.0f}) {
        const DiffuseShape shape(roughness);
        CHECK(shape.at(up, up, 1) == 1);
        CHECK(shape.at(level, up, std::sqrt(0.5f)) == Approx(0.5 + static_cast<double>(roughness)));
        CHECK(shape.at(level, level, 1) == Approx(std::pow(0.5 + 2 * static_cast<double>(roughness), 2)));
        CHECK(shape.at(level, back, 0) == Approx(0.25));
    }
    CHECK(DiffuseShape().at(level, back, 0) == 1);
}

// With alpha = 1 every facet direction is equally likely, and for a viewer above the integral is 1 - ln 2.
TEST_CASE("bsdf: the roughest facets' albedo of one bounce at normal incidence has its closed form")
{
    CHECK(static_cast<double>(1 - FacetTable(1).lost(1)) == Approx(1 - std::log(2.0)).margin(kQuadrature));
}

TEST_CASE("material: a partly metallic surface is the mixture of metal and paint by its metalness")
{
    constexpr int kSteps = 1000;
    Material m;
    m.base = {0.8f, 0.4f, 0.2f};
    m.metalness = 0.25f;
    m.specular = true;
    m.alpha = 0.4f;
    m.finish();
    const Vec3 wo = direction_at(0.7f, 0.1f), wi = direction_at(0.7f, 0.6f);
    double mean = 0;
    for (int k = 0; k < kSteps; ++k) {
        const float u = (static_cast<float>(k) + 0.5f) / kSteps;
        mean += static_cast<double>(m.bsdf(plain_values(m), u).eval(wo, wi).r) / kSteps;
    }
    const double metal = static_cast<double>(Conductor(m.base, *m.facets[0]).eval(wo, wi).r);
    const double paint = static_cast<double>(Plastic(m.base, *m.skins[0]).eval(wo, wi).r);
    CHECK(mean == Approx(0.25 * metal + 0.75 * paint).epsilon(1e-4));
    CHECK(std::abs(metal - paint) > 0.02);
}

TEST_CASE("material: those of the same widths and index share their tables")
{
    const auto made = [](float alpha, float anisotropy, bool glass) {
        Material m;
        m.alpha = alpha;
        m.anisotropy = anisotropy;
        m.metalness = 0.5f;
        m.coat = m.sheen = 1;
        m.specular = true;
        m.glass = glass;
        m.finish();
        return m;
    };
    const Material a = made(0.4f, 0, false), b = made(0.4f, 0, false), c = made(0.5f, 0, false);
    CHECK(a.skins == b.skins);
    CHECK(a.facets == b.facets);
    CHECK(a.coat_skin == b.coat_skin);
    CHECK(a.fibres == b.fibres);
    CHECK(a.skins[0] != c.skins[0]);
    CHECK(a.facets[0] != c.facets[0]);
    const Material brushed = made(0.4f, 0.5f, false), more_brushed = made(0.4f, 0.6f, false);
    CHECK(brushed.brushed_skins == made(0.4f, 0.5f, false).brushed_skins);
    CHECK(brushed.brushed_facets == made(0.4f, 0.5f, false).brushed_facets);
    CHECK(brushed.brushed_skins[0] != more_brushed.brushed_skins[0]);
    const Material frosted = made(0.4f, 0, true);
    CHECK(frosted.frosts == made(0.4f, 0, true).frosts);
    CHECK(frosted.frosts != made(0.5f, 0, true).frosts);
    // A shared table is that of its own width.
    CHECK(c.skins[0]->albedo(0.5f) == Skin(kSkinIndex, 0.5f).albedo(0.5f));
    CHECK(b.facets[0]->lost(0.5f) == FacetTable(0.4f).lost(0.5f));
}

TEST_CASE("material: what is no number becomes the least of its range, and shows finite colours")
{
    constexpr float kNot = std::numeric_limits<float>::quiet_NaN();
    for (const bool glass : {false, true}) {
        Material m;
        for (const MaterialParameter& parameter : kMaterialParameters)
            std::visit([&](auto member) { m.*member = m.*member * kNot; }, parameter.member);
        m.glass = glass;
        m.specular = true;
        m.finish();
        for (const MaterialParameter& parameter : kMaterialParameters) {
            INFO("parameter " << &parameter - kMaterialParameters);
            std::visit(
                [&](auto member) {
                    if constexpr (std::is_same_v<decltype(member), float MaterialNumbers::*>)
                        CHECK(std::isfinite(m.*member));
                    else
                        CHECK(std::isfinite((m.*member).r + (m.*member).g + (m.*member).b));
                },
                parameter.member);
        }
        CHECK(m.absorbed(1).r >= 0);
    }
}

TEST_CASE("material: a picture shows a colour at any place, also where that is no number")
{
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    const Texture picture{2, 1, {255, 0, 0, 0, 255, 0}, true};
    for (const float far_off : {kInfinite, -kInfinite, kInfinite - kInfinite, 1e38f, -1e38f}) {
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
            INFO(far_off << ", " << static_cast<int>(wrap));
            const Rgb seen = picture.at({far_off, far_off}, {wrap, wrap});
            CHECK(seen.r + seen.g == Approx(1));
        }
    }
}

TEST_CASE("fresnel: reflectance at normal incidence and at grazing, and a smooth skin's mean")
{
    CHECK(static_cast<double>(dielectric_reflectance(1, 1.5f)) == Approx(0.04).epsilon(1e-5));
    CHECK(static_cast<double>(dielectric_reflectance(0, 1.5f)) == Approx(1).epsilon(1e-5));
    // Egan & Hilgeman, "Optical Properties of Inhomogeneous Materials", 1979: 0.0918 for n = 1.5.
    CHECK(static_cast<double>(Skin(1.5f, 0.01f).mean_albedo()) == Approx(0.0918).epsilon(0.02));
}

}  // namespace lumi::baker
