// SPDX-License-Identifier: MIT
// Clear and frosted dielectrics, and coats: energy, reciprocity, densities, absorption.
#include <catch2/catch.hpp>
#include <map>

#include "material/bsdf.h"
#include "material/lobes.h"
#include "math/sampler.h"
#include "math/warp.h"
#include "support/direction_bins.h"
#include "support/shapes.h"
#include "support/statistics.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{
namespace
{

using testing::chi2_score;
using testing::kSigmas;
using testing::Mean;
using testing::SceneMaker;

constexpr float kIndex = 1.5f;
constexpr float kAlphas[] = {0.01f, 0.05f, 0.2f, 0.5f, 1.0f};
constexpr float kCosines[] = {1.0f, 0.9f, 0.7f, 0.5f, 0.2f, 0.05f};

RoughGlass frosted(float alpha, bool outside)
{
    static std::map<float, GlassTable> tables;  // a RoughGlass borrows its table
    return RoughGlass(tables.try_emplace(alpha, kIndex, alpha).first->second, outside);
}

Bsdf coated(float base_alpha, float coat_alpha, bool metal)
{
    static std::map<float, Skin> skins;
    static std::map<float, FacetTable> facets;
    const Skin& coat = skins.try_emplace(coat_alpha, kIndex, coat_alpha).first->second;
    if (!metal) return Bsdf(Coated(Diffuse(grey(1)), coat, 1));
    return Bsdf(Coated(Conductor(grey(1), facets.try_emplace(base_alpha, base_alpha).first->second), coat, 1));
}

// The mean share of light that is sent on: transmitted radiance counts by what it carries of the energy.
Mean albedo(const Bsdf& bsdf, const Vec3& wo, float eta)
{
    Mean mean;
    for (uint32_t k = 0; k < 20000; ++k) {
        Sampler sampler(11, k, 3);
        const float u = sampler.next_1d();
        const std::optional<BsdfSample> s = bsdf.sample(wo, u, sampler.next_2d());
        mean.add(!s ? 0.0 : static_cast<double>(s->weight.g * (s->wi.z < 0 ? eta * eta : 1)));
    }
    return mean;
}

constexpr int kGlassHeights = 32, kGlassTurns = 32;

size_t glass_bin(const Vec3& d)
{
    return testing::direction_bin(d, kGlassHeights, kGlassTurns);
}

// A slab of the given thickness between two large panes, seen straight on against a glowing wall.
double through_slab(float thickness, float alpha)
{
    SceneMaker maker;
    const uint32_t pane = maker.add(testing::glass(kIndex, alpha, {0.25f, 0.5f, 1}));
    maker.box(pane, {-0.5f, -0.5f, 0}, {0.5f, 0.5f, thickness});
    const uint32_t wall = maker.add(testing::lamp(grey(1)));
    maker.quad(wall, {-0.6f, -0.6f, -0.3f}, {0.6f, -0.6f, -0.3f}, {0.6f, 0.6f, -0.3f}, {-0.6f, 0.6f, -0.3f});
    maker.span_unit_sphere();
    const Scene scene = maker.make(constant_environment(0));
    const PathTracer tracer(scene.data());
    Mean mean;
    for (uint32_t k = 0; k < 40000; ++k) {
        Sampler sampler(5, k, 0);
        mean.add(static_cast<double>(tracer.trace({{0.01f, 0.02f, 0.9f}, {0, 0, -1}}, sampler).radiance.g));
    }
    CHECK(mean.error() < 0.01);
    return mean.value();
}

}  // namespace

TEST_CASE("glass: a frosted boundary passes on all light, from either side and at every roughness")
{
    for (const float alpha : kAlphas) {
        for (const bool outside : {true, false}) {
            const float eta = outside ? kIndex : 1 / kIndex;
            for (const float z : kCosines) {
                const Mean mean = albedo(Bsdf(frosted(alpha, outside)), direction_at(z, 0.13f), eta);
                INFO("alpha " << alpha << (outside ? " outside " : " inside ") << z << ": " << mean.value() << " ± "
                              << mean.error());
                CHECK(mean.value() == Approx(1).margin(kSigmas * mean.error() + 0.012));
            }
        }
    }
}

TEST_CASE("glass: a polished boundary passes on all light and obeys Snell and Fresnel")
{
    for (const float eta : {kIndex, 1 / kIndex}) {
        for (const float z : kCosines) {
            const Vec3 wo = direction_at(z, 0.3f);
            const float reflectance = dielectric_reflectance(z, eta);
            const auto mirror = SmoothGlass(eta).sample(wo, reflectance * 0.5f, {});
            REQUIRE(mirror);
            CHECK(mirror->wi.z == wo.z);
            CHECK(std::isinf(mirror->pdf));
            if (reflectance < 1) {
                const auto through = SmoothGlass(eta).sample(wo, (1 + reflectance) / 2, {});
                REQUIRE(through);
                CHECK(through->wi.z < 0);
                CHECK(static_cast<double>(std::sqrt(1 - z * z)) ==
                      Approx(static_cast<double>(eta * std::hypot(through->wi.x, through->wi.y))).margin(1e-5));
                CHECK(static_cast<double>(through->weight.g * eta * eta) == Approx(1));
            }
        }
    }
    CHECK(dielectric_reflectance(0.5f, 1 / kIndex) == 1);  // total reflection beyond 41.8 degrees
}

TEST_CASE("glass: reciprocal, with the square of the index for light that crosses")
{
    for (const float alpha : kAlphas) {
        const RoughGlass outer = frosted(alpha, true), inner = frosted(alpha, false);
        for (uint32_t k = 0; k < 2000; ++k) {
            Sampler sampler(5, k, 2);
            const Vec2 u = sampler.next_2d(), v = sampler.next_2d();
            const Vec3 a = direction_at(0.02f + 0.98f * u.x, u.y), b = direction_at(0.02f + 0.98f * v.x, v.y);
            INFO("alpha " << alpha << ", pair " << k);
            const double ab = static_cast<double>(outer.eval(a, b).g / b.z);
            CHECK(ab == Approx(static_cast<double>(outer.eval(b, a).g / a.z)).epsilon(2e-3).margin(1e-6));
            // a outside, b below the surface: seen from there both are mirrored.
            const double out = static_cast<double>(outer.eval(a, {b.x, b.y, -b.z}).g / b.z);
            const double in = static_cast<double>(inner.eval({b.x, b.y, b.z}, {a.x, a.y, -a.z}).g / a.z);
            CHECK(out * static_cast<double>(kIndex * kIndex) == Approx(in).epsilon(2e-3).margin(1e-5));
        }
    }
}

TEST_CASE("glass: the pdf integrates to one minus the samples that are lost, and samples follow it")
{
    constexpr uint32_t kSamples = 100000;
    constexpr int kFine = 10;
    for (const float alpha : {0.2f, 0.5f, 1.0f}) {
        for (const bool outside : {true, false}) {
            for (const float z : {0.9f, 0.6f, 0.2f}) {
                const RoughGlass bsdf = frosted(alpha, outside);
                const Vec3 wo = direction_at(z, 0.13f);
                INFO("alpha " << alpha << (outside ? " outside " : " inside ") << z);
                std::vector<double> expected(kGlassHeights * kGlassTurns), counts(kGlassHeights * kGlassTurns);
                double total = 0;
                for (int k = 0; k < kGlassHeights * kFine * kGlassTurns * kFine; ++k) {
                    const float h =
                        (static_cast<float>(k / (kGlassTurns * kFine)) + 0.5f) / (kGlassHeights * kFine) * 2 - 1;
                    const Vec3 wi =
                        direction_at(h, (static_cast<float>(k % (kGlassTurns * kFine)) + 0.5f) / (kGlassTurns * kFine));
                    const double share = static_cast<double>(bsdf.pdf(wo, wi)) * 4 * static_cast<double>(kPi) /
                                         (kGlassHeights * kFine * kGlassTurns * kFine);
                    expected[glass_bin(wi)] += share;
                    total += share;
                }
                double lost = 0;
                for (uint32_t k = 0; k < kSamples; ++k) {
                    Sampler sampler(7, k, 0);
                    const float u = sampler.next_1d();
                    const std::optional<BsdfSample> s = bsdf.sample(wo, u, sampler.next_2d());
                    lost += s ? 0 : 1;
                    if (s) ++counts[glass_bin(s->wi)];
                }
                CHECK(total + lost / kSamples == Approx(1).margin(0.015));
                expected.push_back(lost / kSamples);
                counts.push_back(lost);
                for (double& e : expected) e *= kSamples / (total + lost / kSamples);
                CHECK(chi2_score(counts, expected) < kSigmas);
            }
        }
    }
}

TEST_CASE("coat: never gains, and loses at most its mean reflectance")
{
    for (const bool metal : {false, true}) {
        for (const float base : kAlphas) {
            for (const float coat : {0.01f, 0.2f, 1.0f}) {
                for (const float z : kCosines) {
                    const Mean mean = albedo(coated(base, coat, metal), direction_at(z, 0.13f), 1);
                    INFO((metal ? "metal " : "diffuse ")
                         << base << " coat " << coat << " at " << z << ": " << mean.value() << " ± " << mean.error());
                    CHECK(mean.value() <= 1 + kSigmas * mean.error() + 0.004);
                    CHECK(mean.value() >= 0.90 - kSigmas * mean.error());
                }
            }
        }
    }
}

TEST_CASE("coat: reciprocal, its pdf integrates to one")
{
    const Bsdf bsdf = coated(0.3f, 0.2f, true);
    for (uint32_t k = 0; k < 500; ++k) {
        Sampler sampler(5, k, 2);
        const Vec2 u = sampler.next_2d(), v = sampler.next_2d();
        const Vec3 a = direction_at(0.02f + 0.98f * u.x, u.y), b = direction_at(0.02f + 0.98f * v.x, v.y);
        CHECK(static_cast<double>(bsdf.eval(a, b).g / b.z) ==
              Approx(static_cast<double>(bsdf.eval(b, a).g / a.z)).epsilon(1e-3).margin(1e-6));
    }
    Mean density;
    uint32_t lost = 0;
    const Vec3 wo = direction_at(0.6f, 0.2f);
    constexpr uint32_t kSamples = 200000;
    for (uint32_t k = 0; k < kSamples; ++k) {
        Sampler sampler(6, k, 2);
        const Vec3 wi = square_to_sphere(sampler.next_2d());
        density.add(wi.z > 0 ? static_cast<double>(bsdf.pdf(wo, wi)) * 4 * static_cast<double>(kPi) : 0.0);
        lost += bsdf.sample(wo, sampler.next_1d(), sampler.next_2d()) ? 0u : 1u;
    }
    CHECK(density.value() == Approx(1 - lost / static_cast<double>(kSamples)).margin(kSigmas * density.error() + 2e-3));
}

// Two surfaces of reflectance r around a medium of transmittance t: (1-r)²t / (1-r²t²).
TEST_CASE("glass: a slab lets through what Fresnel and Beer leave")
{
    for (const float thickness : {0.05f, 0.3f}) {
        const double t = std::pow(0.5, static_cast<double>(thickness));
        const double r = 0.04;
        const double expected = (1 - r) * (1 - r) * t / (1 - r * r * t * t);
        CHECK(through_slab(thickness, 0) == Approx(expected).epsilon(0.005));
    }
}

// A body that neither absorbs nor gains is invisible in light that comes from everywhere alike.
TEST_CASE("glass: clear and frosted balls and boxes vanish in constant light")
{
    for (const float alpha : {0.0f, 0.1f, 0.5f, 1.0f}) {
        for (const bool round : {true, false}) {
            SceneMaker maker;
            const uint32_t glass = maker.add(testing::glass(kIndex, alpha));
            if (round)
                maker.ball(glass, {}, 0.6f, 12);
            else
                maker.box(glass, {-0.4f, -0.4f, -0.4f}, {0.4f, 0.4f, 0.4f});
            maker.span_unit_sphere();
            const Scene scene = maker.make(constant_environment(0.7f));
            const PathTracer tracer(scene.data());
            Mean mean;
            for (uint32_t k = 0; k < 6000; ++k) {
                Sampler sampler(9, k, 0);
                const Vec3 start = square_to_sphere(sampler.next_2d()) * 1.2f;
                const Vec3 target = square_to_sphere(sampler.next_2d()) * 0.2f;
                mean.add(static_cast<double>(tracer.trace({start, normalized(target - start)}, sampler).radiance.g));
            }
            INFO("alpha " << alpha << (round ? " ball " : " box ") << mean.value() << " ± " << mean.error());
            // Light that runs round inside a box by total reflection ends with the path's length.
            CHECK(mean.value() == Approx(0.7).margin(kSigmas * mean.error() + 0.012));
        }
    }
}

}  // namespace lumi::baker
