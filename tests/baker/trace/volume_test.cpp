// SPDX-License-Identifier: MIT
// Light in volumes: closed forms, white clouds in white light, who is covered and what throws shadows.
#include <catch2/catch.hpp>

#include "support/shapes.h"
#include "support/statistics.h"
#include "support/volumes.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{
namespace
{

using testing::kSigmas;
using testing::Mean;
using testing::SceneMaker;

constexpr Vec3 kLow = {-0.4f, -0.4f, -0.4f}, kHigh = {0.4f, 0.4f, 0.4f};

struct Seen {
    Mean covered, light, gain;  // gain: light less what cover of radiance 1 would give
};

Seen seen(const Scene& scene, const Ray& ray, uint32_t paths)
{
    const PathTracer tracer(scene.data());
    Seen result;
    for (uint32_t k = 0; k < paths; ++k) {
        Sampler sampler(21, k, 0);
        const PathResult path = tracer.trace(ray, sampler);
        const double covered = path.covered ? 1 : 0, light = static_cast<double>(path.radiance.g);
        result.covered.add(covered);
        result.light.add(light);
        result.gain.add(light - covered);
    }
    return result;
}

void check_mean(const Mean& mean, double expected, double tolerance = 1e-5)
{
    INFO(mean.value() << " for " << expected << " +- " << mean.error());
    CHECK(std::abs(mean.value() - expected) <= kSigmas * mean.error() + tolerance * expected);
}

Scene lit(const Volume& volume, const Fixture& light)
{
    SceneMaker maker;
    maker.span_unit_sphere();
    maker.fill(volume);
    maker.add(light);
    return maker.make(constant_environment(0));
}

// A ball of even density: the grid holds distances from its centre.
Volume cloud(float density, float radius, const Rgb& colour, float anisotropy = 0)
{
    const float r = radius * 1.2f;
    const Vec3 high = {r, r, r};
    return {testing::grid_of(41, 41, 41, -high, high,
                             [](float x, float y, float z) { return std::sqrt(x * x + y * y + z * z); }),
            TransferFunction({{radius, colour, density}, {radius * 1.0001f, colour, 0}}), anisotropy};
}

// How far a way leads inside a ball around the origin, from a point in it.
double way_out(double radius, double along, double distance2)
{
    return -along + std::sqrt(along * along + radius * radius - distance2);
}

}  // namespace

TEST_CASE("volume: a ray is covered as often as the fog stops it")
{
    for (const float density : {0.5f, 3.0f}) {
        SceneMaker maker;
        maker.span_unit_sphere();
        maker.fill(testing::fog(density, grey(0), kLow, kHigh));
        const Scene scene = maker.make(constant_environment(1));
        const Seen result = seen(scene, {{-1, 0.1f, 0.2f}, {1, 0, 0}}, 20000);
        check_mean(result.covered, 1 - std::exp(-0.8 * static_cast<double>(density)));
        CHECK(result.light.value() == 0);
    }
}

// Light falls from above, the ray is level: L = a·E·p·exp(-σ·d)·(1 - exp(-2hσ)). So dark that what scatters twice is
// below the tolerance.
TEST_CASE("volume: a dark box of fog scatters what the closed form for one scattering says")
{
    constexpr float kAlbedo = 1e-4f, kDensity = 2.5f;
    for (const float g : {0.0f, 0.6f}) {
        Volume volume = testing::fog(kDensity, grey(kAlbedo), kLow, kHigh);
        volume.anisotropy = g;
        const Scene scene = lit(volume, DirectionalLight{{0, 0, 1}, grey(3)});
        const double s = static_cast<double>(kDensity), g2 = static_cast<double>(g * g);
        const double phase = (1 - g2) / (4 * static_cast<double>(kPi) * std::pow(1 + g2, 1.5));
        const double expected =
            static_cast<double>(3 * kAlbedo) * phase * std::exp(-s * 0.3) * (1 - std::exp(-s * 0.8));
        check_mean(seen(scene, {{-1, 0.05f, 0.1f}, {1, 0, 0}}, 40000).light, expected, 4e-4);
    }
}

TEST_CASE("volume: a dark ball of fog scatters what quadrature over the ray says")
{
    constexpr float kAlbedo = 1e-4f, kDensity = 4, kRadius = 0.4f, kHeight = 0.15f;
    const Scene scene = lit(cloud(kDensity, kRadius, grey(kAlbedo)), PointLight{{0.2f, 0.5f, 0.9f}, grey(2)});
    constexpr int kSteps = 20000;
    const double radius = static_cast<double>(kRadius), height = static_cast<double>(kHeight);
    const double half = std::sqrt(radius * radius - height * height);
    double sum = 0;
    for (int k = 0; k < kSteps; ++k) {
        const double x = half * (2 * (k + 0.5) / kSteps - 1);
        const double to[3] = {0.2 - x, 0.5, 0.9 - height};
        const double d2 = to[0] * to[0] + to[1] * to[1] + to[2] * to[2], d = std::sqrt(d2);
        const double inside = way_out(radius, (x * to[0] + height * to[2]) / d, x * x + height * height);
        sum += std::exp(-static_cast<double>(kDensity) * (x + half + inside)) / d2;
    }
    const double expected = sum * 2 * half / kSteps * static_cast<double>(2 * kAlbedo * kDensity / (4 * kPi));
    // The grid's ball differs from a true one by a share of 1e-3 of its radius.
    check_mean(seen(scene, {{-1, 0, kHeight}, {1, 0, 0}}, 40000).light, expected, 3e-3);
}

TEST_CASE("volume: a white cloud in white light is white, thin or thick, even or not, with a white ball inside")
{
    for (const float density : {1.0f, 20.0f}) {
        for (const float g : {0.0f, 0.7f}) {
            SceneMaker maker;
            maker.span_unit_sphere();
            maker.fill(cloud(density, 0.5f, grey(1), g));
            const Scene scene = maker.make(constant_environment(1));
            const Seen result = seen(scene, {{-1, 0.1f, 0.2f}, {1, 0, 0}}, 4000);
            INFO("density " << density << ", g " << g);
            check_mean(result.covered, 1 - std::exp(-2 * static_cast<double>(density) * std::sqrt(0.2)), 3e-3);
            INFO(result.gain.value() << " +- " << result.gain.error());
            CHECK(std::abs(result.gain.value()) <= kSigmas * result.gain.error() + 1e-5);
        }
    }
    SceneMaker maker;
    Volume volume = testing::smoke();
    volume.transfer = TransferFunction({{2, grey(1), 0}, {5, grey(1), 30}, {9, grey(1), 3}});
    maker.fill(volume);
    maker.ball(maker.add(testing::diffuse(grey(1))), {-0.1f, 0, -0.1f}, 0.2f, 8);
    maker.span_unit_sphere();
    const Scene scene = maker.make(constant_environment(1));
    for (uint32_t r = 0; r < 6; ++r) {
        Sampler aim(9, r, 0);
        const Vec3 start = square_to_sphere(aim.next_2d()), end = square_to_sphere(aim.next_2d()) * 0.3f;
        const Mean gain = seen(scene, {start, normalized(end - start)}, 4000).gain;
        INFO(gain.value() << " +- " << gain.error());
        // Paths on white surfaces end after 64 bounces: a loss below 0.2 %.
        CHECK(std::abs(gain.value()) <= kSigmas * gain.error() + 2e-3);
    }
}

TEST_CASE("volume: fog throws its shadow on the floor below")
{
    const double through = std::exp(-1.5 * 0.8);
    const Ray down_beside_fog = {{-0.7f, 0.05f, 0.3f}, normalized(Vec3{0.75f, 0, -0.8f})};
    SceneMaker floor;
    floor.span_unit_sphere();
    floor.fill(testing::fog(1.5f, grey(0), {-0.1f, -0.1f, -0.1f}, {0.1f, 0.1f, 0.7f}));
    floor.add(DirectionalLight{{0, 0, 1}, grey(2)});
    constexpr float kLevel = -0.5f;
    floor.quad(floor.add(testing::diffuse(grey(0.5f))), {-0.4f, -0.4f, kLevel}, {0.4f, -0.4f, kLevel},
               {0.4f, 0.4f, kLevel}, {-0.4f, 0.4f, kLevel});
    check_mean(seen(floor.make(constant_environment(0)), down_beside_fog, 20000).light,
               0.5 * 2 / static_cast<double>(kPi) * through);
}

TEST_CASE("volume: a scene of fog alone has a sphere around the parts that are not empty")
{
    SceneMaker maker;
    const auto value = [](float x, float, float) { return x > 0.55f ? 1.0f : 0.0f; };
    maker.fill({testing::grid_of(33, 17, 17, {-1, -0.5f, -0.5f}, {3, 0.5f, 0.5f}, value),
                TransferFunction({{0, grey(1), 0}, {1, grey(1), 5}})});
    const Scene scene = maker.make(constant_environment(1));
    CHECK(scene.triangle_count() == 0);
    CHECK(scene.centre()[0] == Approx(1.5f));  // whole blocks of eight cells: from 0 to 3
    CHECK(static_cast<double>(scene.radius()) == Approx(std::sqrt(1.5 * 1.5 + 0.5)).epsilon(1e-5));
    check_mean(seen(scene, {{0.3f, 0, -1}, {0, 0, 1}}, 4000).covered, 1 - std::exp(-5.0));
}

}  // namespace lumi::baker
