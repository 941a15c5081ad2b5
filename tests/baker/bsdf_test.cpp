// SPDX-License-Identifier: MIT
#include "bsdf.h"

#include <catch2/catch.hpp>
#include <iomanip>
#include <map>
#include <sstream>

#include "fresnel.h"
#include "material.h"
#include "sampler.h"
#include "statistics.h"
#include "warp.h"

namespace lumi::baker
{
namespace
{

using testing::chi2_score;
using testing::kSigmas;

constexpr double kQuadrature = 0.002;  // error of a skin's table

struct Named {
    std::string name;
    Bsdf bsdf;
};

std::string short_text(float number)
{
    std::ostringstream out;
    out << std::fixed << std::setprecision(number < 0.1f ? 2 : 1) << number;
    return out.str();
}

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

std::vector<Vec3> views()
{
    std::vector<Vec3> all;
    for (const float z : {1.0f, 0.9f, 0.5f, 0.2f, 0.05f}) {
        all.push_back(direction_at(z, 0.13f));
    }
    return all;
}

constexpr int kHeights = 24, kTurns = 48;

size_t bin_of(const Vec3& wi)
{
    const float turn = std::atan2(wi.y, wi.x) / (2 * kPi);
    const int h = std::min(static_cast<int>(wi.z * kHeights), kHeights - 1);
    const int t = std::min(static_cast<int>((turn < 0 ? turn + 1 : turn) * kTurns), kTurns - 1);
    return static_cast<size_t>(h * kTurns + t);
}

// The integral of pdf over each bin of the upper hemisphere, by the midpoint rule on a fine grid.
std::vector<double> expected_shares(const Bsdf& bsdf, const Vec3& wo, int steps)
{
    std::vector<double> shares(kHeights * kTurns);
    const double cell = 2 * static_cast<double>(kPi) / (kHeights * steps) / (kTurns * steps);
    for (int h = 0; h < kHeights * steps; ++h) {
        for (int t = 0; t < kTurns * steps; ++t) {
            const float z = (static_cast<float>(h) + 0.5f) / static_cast<float>(kHeights * steps);
            const Vec3 wi = direction_at(z, (static_cast<float>(t) + 0.5f) / static_cast<float>(kTurns * steps));
            shares[bin_of(wi)] += static_cast<double>(bsdf.pdf(wo, wi)) * cell;
        }
    }
    return shares;
}

double sum(const std::vector<double>& v)
{
    double s = 0;
    for (const double x : v) {
        s += x;
    }
    return s;
}

}  // namespace

// Narrow lobes need more than a grid can give; they share every line of code with the wide ones.
TEST_CASE("bsdf: pdf integrates to one minus the samples that are lost, and samples follow it")
{
    constexpr uint32_t kSamples = 100000;
    std::vector<Named> all = {{"diffuse", Bsdf(Diffuse(grey(0.5f)))}};
    for (const float alpha : {0.2f, 0.5f, 1.0f}) {
        all.push_back({"conductor " + short_text(alpha), Bsdf(conductor(0.8f, alpha))});
        all.push_back({"plastic " + short_text(alpha), Bsdf(plastic(0.3f, alpha))});
    }
    for (const Named& named : all) {
        for (const Vec3& wo : views()) {
            INFO(named.name << ", viewer at height " << wo.z);
            std::vector<double> expected = expected_shares(named.bsdf, wo, 8);
            std::vector<double> counts(expected.size());
            uint32_t lost = 0;
            for (uint32_t k = 0; k < kSamples; ++k) {
                Sampler sampler(7, k, 0);
                const float u = sampler.next_1d();
                const std::optional<BsdfSample> s = named.bsdf.sample(wo, u, sampler.next_2d());
                lost += s ? 0u : 1u;
                if (s) {
                    ++counts[bin_of(s->wi)];
                }
            }
            const double share_lost = static_cast<double>(lost) / kSamples;
            // The grid's own error at the narrowest lobe is the larger part of the tolerance.
            CHECK(sum(expected) + share_lost == Approx(1).margin(0.01));
            expected.push_back(share_lost);
            counts.push_back(lost);
            const double total = sum(expected);
            for (double& e : expected) {
                e *= kSamples / total;
            }
            CHECK(chi2_score(counts, expected) < kSigmas);
        }
    }
}

TEST_CASE("bsdf: a sample's weight and pdf are those of its direction")
{
    for (const Named& named : white_bsdfs()) {
        for (const Vec3& wo : views()) {
            for (uint32_t k = 0; k < 200; ++k) {
                Sampler sampler(3, k, 1);
                const float u = sampler.next_1d();
                const std::optional<BsdfSample> s = named.bsdf.sample(wo, u, sampler.next_2d());
                if (!s || s->wi.z < 1e-3f) {
                    continue;
                }
                INFO(named.name << ", viewer at height " << wo.z << ", sample " << k);
                // The half vector is computed anew, which binary32 limits for the narrowest lobe.
                const double tolerance = 0.02;
                CHECK(static_cast<double>(s->pdf) ==
                      Approx(static_cast<double>(named.bsdf.pdf(wo, s->wi))).epsilon(tolerance));
                const double value = static_cast<double>(named.bsdf.eval(wo, s->wi).g);
                CHECK(static_cast<double>(s->weight.g * s->pdf) == Approx(value).epsilon(tolerance));
            }
        }
    }
}

TEST_CASE("bsdf: reciprocal")
{
    for (const Named& named : white_bsdfs()) {
        for (uint32_t k = 0; k < 500; ++k) {
            Sampler sampler(5, k, 2);
            const Vec2 u = sampler.next_2d();
            const Vec2 v = sampler.next_2d();
            const Vec3 a = direction_at(0.02f + 0.98f * u.x, u.y);
            const Vec3 b = direction_at(0.02f + 0.98f * v.x, v.y);
            INFO(named.name << ", pair " << k);
            const double ab = static_cast<double>(named.bsdf.eval(a, b).g / b.z);
            const double ba = static_cast<double>(named.bsdf.eval(b, a).g / a.z);
            CHECK(ab == Approx(ba).epsilon(1e-3).margin(1e-6));
        }
    }
}

TEST_CASE("bsdf: a white furnace neither gains nor loses energy")
{
    constexpr uint32_t kSamples = 20000;
    std::map<std::string, double> losses;
    for (const Named& named : white_bsdfs()) {
        double worst_loss = 0;
        for (const Vec3& wo : views()) {
            testing::Mean albedo;
            for (uint32_t k = 0; k < kSamples; ++k) {
                Sampler sampler(11, k, 3);
                const float u = sampler.next_1d();
                const std::optional<BsdfSample> s = named.bsdf.sample(wo, u, sampler.next_2d());
                albedo.add(s ? static_cast<double>(s->weight.g) : 0.0);
            }
            INFO(named.name << ", viewer at height " << wo.z << ", albedo " << albedo.value() << " ± "
                            << albedo.error());
            CHECK(albedo.value() <= 1 + kSigmas * albedo.error() + kQuadrature);
            worst_loss = std::max(worst_loss, 1 - albedo.value() - kSigmas * albedo.error());
        }
        losses[named.name] = worst_loss;
    }
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
        mean += static_cast<double>(m.bsdf(m.plain_values(), u).eval(wo, wi).r) / kSteps;
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
