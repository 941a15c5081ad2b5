// SPDX-License-Identifier: MIT
// Fibres over every kind of opaque surface.
#include "material/sheen.h"

#include <catch2/catch.hpp>
#include <map>

#include "material/material.h"
#include "math/sampler.h"
#include "math/warp.h"
#include "support/bsdf_checks.h"
#include "support/statistics.h"

namespace lumi::baker
{
namespace
{

using testing::kSigmas;
using testing::Named;
using testing::plain_values;
using testing::short_text;
using testing::views;

constexpr float kRoughnesses[] = {0.1f, 0.3f, 0.6f, 1.0f};

Material white_matt(float roughness)
{
    Material m;
    m.base = grey(1);
    m.sheen = 1;
    m.sheen_roughness = roughness;
    return m;
}

// Over matt paint, plastic, metal, brushed metal and a coat.
std::vector<Material> white_materials(float roughness)
{
    std::vector<Material> all(5, white_matt(roughness));
    for (size_t k = 1; k < 4; ++k) {
        all[k].specular = true;
        all[k].alpha = 0.3f;
        all[k].metalness = k == 1 ? 0 : 1;
    }
    all[3].anisotropy = 0.8f;
    all[4].coat = 1;
    all[4].coat_alpha = 0.2f;
    for (Material& m : all) m.finish();
    return all;
}

constexpr const char* kBodies[] = {"matt", "plastic", "metal", "brushed", "coated"};

std::vector<Named> white_sheened()
{
    static std::map<float, std::vector<Material>> materials;  // BSDFs borrow their tables
    std::vector<Named> all;
    for (const float roughness : kRoughnesses) {
        const auto [entry, fresh] = materials.try_emplace(roughness);
        entry->second = fresh ? white_materials(roughness) : std::move(entry->second);
        for (size_t k = 0; k < entry->second.size(); ++k) {
            const Material& m = entry->second[k];
            all.push_back({std::string(kBodies[k]) + " " + short_text(roughness), m.bsdf(plain_values(m), 0)});
        }
    }
    return all;
}

}  // namespace

TEST_CASE("sheen: pdf integrates to one minus the samples that are lost, and samples follow it")
{
    for (const Named& named : white_sheened())
        check_density(named, {direction_at(0.9f, 0.13f), direction_at(0.2f, 0.13f)}, 10);
}

TEST_CASE("sheen: a sample's weight and pdf are those of its direction")
{
    for (const Named& named : white_sheened()) check_weights(named, views());
}

TEST_CASE("sheen: reciprocal")
{
    for (const Named& named : white_sheened()) check_reciprocal(named);
}

TEST_CASE("sheen: a white furnace gains nothing, over matt paint it loses nothing, over the others a little")
{
    std::map<std::string, double> worst;
    for (const Named& named : white_sheened()) {
        double& entry = worst[named.name.substr(0, named.name.find(' '))];
        entry = std::max(entry, checked_loss(named, views()));
    }
    for (const auto& [body, loss] : worst) {
        INFO(body << " loses " << loss);
        CHECK(loss < (body == "matt" ? 0.002 : 0.16));
    }
}

TEST_CASE("sheen: the table says what the fibres send back in all")
{
    for (const float roughness : kRoughnesses) {
        const SheenTable fibres(roughness);
        for (const Vec3& wo : views()) {
            testing::Mean mean;
            for (uint32_t k = 0; k < 100000; ++k) {
                Sampler sampler(4, k, 0);
                const Vec2 u = sampler.next_2d();
                mean.add(static_cast<double>(fibres.value(wo, direction_at(1 - u.x, u.y)) * 2 * kPi));
            }
            INFO("roughness " << roughness << ", height " << wo.z << ": " << mean.value());
            CHECK(static_cast<double>(fibres.albedo(wo)) ==
                  Approx(mean.value()).margin(kSigmas * mean.error() + 0.002));
        }
    }
}

// Roughness 1/k makes the density (k+2)/2π·sin^k. For k = 2 a viewer at the horizon sees facets of the area
// 2·∫ sin^4 θ·4/2π dθ = 3/4 a unit of surface; with light from above, only facets at 45 degrees, where the density is
// 1/π, turn it to him: 1/π / (4·3/4).
TEST_CASE("sheen: light from above seen from the horizon has its closed form")
{
    const SheenTable fibres(0.5f);
    CHECK(static_cast<double>(fibres.value(direction_at(1e-4f, 0.2f), {0, 0, 1})) ==
          Approx(1 / (3 * static_cast<double>(kPi))).epsilon(2e-3));
    CHECK(static_cast<double>(fibres.value({0, 0, 1}, {0, 0, 1})) == Approx(0).margin(1e-6));
}

TEST_CASE("sheen: black fibres and none leave the surface as it is")
{
    Material m = white_matt(0.3f);
    m.sheen = 0;
    m.finish();
    CHECK_FALSE(m.fibres);
    const Vec3 wo = direction_at(0.4f, 0.1f), wi = direction_at(0.3f, 0.7f);
    CHECK(m.bsdf(plain_values(m), 0).eval(wo, wi).g == Diffuse(grey(1)).eval(wo, wi).g);
    m.sheen = 1;
    m.finish();
    PointValues bald = plain_values(m);
    bald.sheen = 0;  // where a picture says so
    CHECK(m.bsdf(bald, 0).eval(wo, wi).g == Diffuse(grey(1)).eval(wo, wi).g);
    CHECK(m.bsdf(plain_values(m), 0).eval(wo, wi).g != Diffuse(grey(1)).eval(wo, wi).g);
}

}  // namespace lumi::baker
