// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "light/sky.h"
#include "lumi/baker/scene.h"
#include "math/sampler.h"
#include "support/shapes.h"

namespace lumi::baker
{
namespace
{

constexpr int kHeights = 180, kTurns = 360;

// By a grid of directions of equal solid angle.
template <typename Visit>
Rgb mean_over(const Sky& sky, const Visit& weight)
{
    Rgb sum;
    for (int k = 0; k < kHeights * kTurns; ++k) {
        const float z = (static_cast<float>(k / kTurns) + 0.5f) / kHeights * 2 - 1;
        const Vec3 direction = direction_at(z, (static_cast<float>(k % kTurns) + 0.5f) / kTurns);
        sum = sum + sky.at(direction).radiance * (weight(direction) / (kHeights * kTurns));
    }
    return sum;
}

Sky sky_of(const std::string& name)
{
    return Sky(named_environment(name).value());
}

// A white ball sends this back in all.
Rgb energy_of(const Sky& sky)
{
    return mean_over(
        sky, [](const Vec3&) { return 1.0f; });
}

}  // namespace

TEST_CASE("looks: every named sky but black sends the same light to a white ball, and the studio is neutral")
{
    const float expected = luminance(energy_of(sky_of("gradient")));
    for (const char* name : {"studio", "overcast", "evening"}) {
        INFO(name);
        CHECK(luminance(energy_of(sky_of(name))) == Approx(expected).epsilon(0.02));
    }
    const Rgb neutral = energy_of(sky_of("studio"));
    CHECK(neutral.r == neutral.g);
    CHECK(neutral.b == neutral.g);
}

TEST_CASE("looks: the gradient is linear in height between its three colours")
{
    const Sky gradient = sky_of("gradient");
    CHECK(gradient.at({0, 0, 1}).radiance.b == 1.65f);
    CHECK(gradient.at({1, 0, 0}).radiance.g == 0.5f);
    CHECK(gradient.at({0, 0, -1}).radiance.r == 0.16f);
}

TEST_CASE("looks: in the studio a white of 0.8 stays below clipping wherever it faces, and a dark side is left")
{
    const Sky sky = sky_of("studio");
    float brightest = 0, darkest = 1;
    for (uint32_t k = 0; k < 200; ++k) {
        Sampler sampler(1, k, 0);
        const Vec3 normal = square_to_sphere(sampler.next_2d());
        // The irradiance over π, a mean over the sphere with four cosines.
        const float light =
            luminance(mean_over(sky, [&](const Vec3& d) { return 4 * std::max(0.0f, dot(d, normal)); }));
        brightest = std::max(brightest, light);
        darkest = std::min(darkest, light);
    }
    INFO(darkest << " to " << brightest);
    CHECK(0.8f * brightest < 1);
    CHECK(0.8f * brightest > 0.9f);
    CHECK(darkest < 0.25f * brightest);
}

TEST_CASE("looks: the studio's soft boxes are mirrored: bright ones with edges before a dark room")
{
    const Sky sky = sky_of("studio");
    const float key = sky.at(direction_at(std::sin(17 * kPi / 180), -54 / 360.0f)).radiance.g;
    const float beside = sky.at(direction_at(std::sin(17 * kPi / 180), -85 / 360.0f)).radiance.g;
    CHECK(key > 5);
    CHECK(beside < 0.2f);
}

TEST_CASE("looks: a named sky has no unit to find out, so no exposure is chosen for it")
{
    for (const bool needs : {false, true}) {
        testing::SceneMaker maker;
        maker.ball(maker.add(testing::diffuse(grey(0.5f))), {}, 0.5f);
        Environment dim = named_environment("studio").value();
        dim.scale = 0.1f;
        dim.needs_exposure = needs;
        maker.surround(dim);
        CHECK((maker.make_open().data().choice.exposure == 1) == !needs);
    }
}

}  // namespace lumi::baker
