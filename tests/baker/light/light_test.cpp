// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "light/light_set.h"
#include "math/sampler.h"
#include "support/direction_bins.h"
#include "support/shapes.h"
#include "support/statistics.h"

namespace lumi::baker
{
namespace
{

using testing::chi2_score;
using testing::kSigmas;
using testing::Mean;

constexpr int kSkyHeights = 20, kSkyTurns = 16;

size_t sky_bin(const Vec3& d)
{
    return testing::direction_bin(d, kSkyHeights, kSkyTurns);
}

const Environment kSkies[] = {constant_environment(1),
                              gradient_environment(),
                              {{5, 5, 5}, {0, 0, 0}, {0, 0, 0}},
                              {{0, 0, 0}, {1, 2, 3}, {0, 0, 0}}};

}  // namespace

TEST_CASE("sky: its pdf integrates to one and its samples follow it")
{
    constexpr uint32_t kSamples = 100000;
    constexpr int kFine = 16;
    for (const Environment& environment : kSkies) {
        const Sky sky(environment);
        std::vector<double> expected(kSkyHeights * kSkyTurns), counts(kSkyHeights * kSkyTurns);
        double total = 0;
        for (int h = 0; h < kSkyHeights * kFine; ++h) {
            const float z = -1 + (static_cast<float>(h) + 0.5f) * 2 / (kSkyHeights * kFine);
            for (int t = 0; t < kSkyTurns; ++t) {
                const Vec3 d = direction_at(z, (static_cast<float>(t) + 0.5f) / kSkyTurns);
                const double share = static_cast<double>(sky.at(d).pdf) * 4 * static_cast<double>(kPi) /
                                     (kSkyHeights * kFine * kSkyTurns);
                expected[sky_bin(d)] += share * kSamples;
                total += share;
            }
        }
        CHECK(total == Approx(1).epsilon(1e-3));
        for (uint32_t k = 0; k < kSamples; ++k) {
            Sampler sampler(1, k, 0);
            const float u = sampler.next_1d();
            const LightSample s = sky.sample({}, u, sampler.next_2d());
            REQUIRE(s.pdf == sky.at(s.direction).pdf);
            ++counts[sky_bin(s.direction)];
        }
        CHECK(chi2_score(counts, expected) < kSigmas);
    }
}

TEST_CASE("lights: what they send to a point is the same by light sampling and by looking everywhere")
{
    testing::SceneMaker maker;
    const uint32_t bright = maker.add(testing::lamp({4, 2, 1}));
    const uint32_t dim = maker.add(testing::lamp({0.1f, 0.3f, 0.6f}));
    maker.quad(bright, {0.3f, -0.2f, 0.5f}, {0.3f, 0.2f, 0.6f}, {-0.2f, 0.3f, 0.6f}, {-0.2f, -0.2f, 0.4f});
    maker.quad(dim, {-0.5f, -0.5f, -0.5f}, {0.5f, -0.5f, -0.5f}, {0.5f, -0.5f, 0.5f}, {-0.5f, -0.5f, 0.5f});
    maker.span_unit_sphere();
    const Scene scene = maker.make(gradient_environment());
    const SceneData& data = scene.data();
    const Vec3 point = {0.1f, 0.05f, -0.1f};

    Mean aimed, samples, everywhere, density;
    for (uint32_t k = 0; k < 100000; ++k) {
        Sampler sampler(2, k, 0);
        const Vec2 choice = sampler.next_2d();
        double arrived = 0, taken = 0;
        data.lights.sample(point, {choice, sampler.next_2d()}, [&](const LightSample& s, float) {
            const bool visible = !data.accelerator.blocked({point, s.direction, s.distance * 0.999f});
            arrived += visible ? static_cast<double>(s.radiance.r / s.pdf) : 0.0;
            ++taken;
        });
        aimed.add(arrived);
        samples.add(taken);

        const Vec3 d = square_to_sphere(sampler.next_2d());
        const std::optional<Hit> hit = data.accelerator.closest({point, d});
        const Rgb seen =
            hit ? data.materials[data.mesh.materials[hit->triangle]].emission : data.lights.sky(d).radiance;
        everywhere.add(static_cast<double>(seen.r) * 4 * static_cast<double>(kPi));

        // The densities of sky and emitters, both along d, add up to the number of samples.
        double pdf = static_cast<double>(data.lights.sky(d).pdf);
        if (hit && data.materials[data.mesh.materials[hit->triangle]].emits())
            pdf += static_cast<double>(data.lights.emitter_pdf(hit->triangle, d, hit->distance));
        density.add(pdf * 4 * static_cast<double>(kPi));
    }
    INFO(aimed.value() << " aimed, " << everywhere.value() << " everywhere");
    CHECK(std::abs(aimed.value() - everywhere.value()) < kSigmas * std::hypot(aimed.error(), everywhere.error()));
    INFO(samples.value() << " samples, of density " << density.value());
    CHECK(std::abs(density.value() - samples.value()) < kSigmas * std::hypot(density.error(), samples.error()));
    CHECK(samples.value() > 1.1);
    CHECK(samples.value() < 2);
}

TEST_CASE("lights: a dark scene has none")
{
    testing::SceneMaker maker;
    maker.ball(maker.add(testing::diffuse(grey(0.5f))), {}, 1);
    CHECK(maker.make(constant_environment(0)).data().lights.empty());
}

TEST_CASE("points take two samples where sky and lamps both shine, and two are allowed")
{
    const Mesh none;
    const Environment dark = constant_environment(0), bright = constant_environment(1);
    const std::vector<Fixture> lamp = {PointLight{{0, 0, 1}, grey(1)}};
    const auto takes_two = [&](const Environment& sky, const std::vector<Fixture>& lamps, float samples) {
        return LightSet(none, {}, {}, sky, lamps, samples).takes_two();
    };
    CHECK(takes_two(bright, lamp, 2));
    CHECK_FALSE(takes_two(bright, lamp, 1));
    CHECK_FALSE(takes_two(bright, {}, 2));
    CHECK_FALSE(takes_two(dark, lamp, 2));
}

}  // namespace lumi::baker
