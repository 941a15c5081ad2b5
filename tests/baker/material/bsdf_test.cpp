// SPDX-License-Identifier: MIT
#include "material/bsdf.h"

#include <catch2/catch.hpp>
#include <map>

#include "material/fresnel.h"
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

Plastic plastic(float albedo, float alpha)
{
    static std::map<float, Skin> skins;  // a Plastic borrows its skin
    return Plastic(grey(albedo), skins.try_emplace(alpha, 1.5f, alpha).first->second);
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
    for (const Named& named : all) check_density(named, views());
}

TEST_CASE("bsdf: a sample's weight and pdf are those of its direction")
{
    for (const Named& named : white_bsdfs()) check_weights(named, views());
}

TEST_CASE("bsdf: reciprocal")
{
    for (const Named& named : white_bsdfs()) check_reciprocal(named);
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

TEST_CASE("fresnel: reflectance at normal incidence and at grazing, and a smooth skin's mean")
{
    CHECK(static_cast<double>(dielectric_reflectance(1, 1.5f)) == Approx(0.04).epsilon(1e-5));
    CHECK(static_cast<double>(dielectric_reflectance(0, 1.5f)) == Approx(1).epsilon(1e-5));
    // Egan & Hilgeman, "Optical Properties of Inhomogeneous Materials", 1979: 0.0918 for n = 1.5.
    CHECK(static_cast<double>(Skin(1.5f, 0.01f).mean_albedo()) == Approx(0.0918).epsilon(0.02));
}

}  // namespace lumi::baker
