// SPDX-License-Identifier: MIT
#include "trace/path_tracer.h"

#include <catch2/catch.hpp>

#include "support/brute_force.h"

namespace lumi::baker
{
namespace
{

using testing::add_room;
using testing::kSigmas;
using testing::Mean;
using testing::radiance;
using testing::SceneMaker;

Mean along(const Scene& scene, const Ray& ray, uint32_t paths)
{
    const PathTracer tracer(scene.data());
    Mean mean;
    for (uint32_t k = 0; k < paths; ++k) {
        Sampler sampler(21, k, 0);
        mean.add(static_cast<double>(tracer.trace(ray, sampler).radiance.g));
    }
    return mean;
}

Scene square_of(const Material& material)
{
    SceneMaker maker;
    maker.quad(maker.add(material), {-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0});
    return maker.make(constant_environment(1));
}

}  // namespace

TEST_CASE("path tracer: a convex diffuse body in constant light has radiance albedo × light everywhere")
{
    SceneMaker maker;
    maker.ball(maker.add(testing::diffuse(grey(0.6f))), {}, 1);
    const Scene scene = maker.make(constant_environment(0.8f));
    for (uint32_t r = 0; r < 20; ++r) {
        Sampler aim(1, r, 0);
        const Vec3 start = square_to_sphere(aim.next_2d()) * 2;
        const Mean mean = along(scene, {start, normalized(square_to_sphere(aim.next_2d()) * 0.5f - start)}, 2000);
        CHECK(mean.value() == Approx(0.48).margin(kSigmas * mean.error() + 1e-4));
    }
}

// Samples of a picture go to what is brighter than its mean, rays by the surface find the rest.
TEST_CASE("path tracer: a floor under a sky's picture sends back all of its light, of a sun as of an even sky")
{
    for (const float sun : {100.0f, 0.5f, 0.2f}) {
        auto picture = std::make_shared<RadiancePicture>(RadiancePicture{16, 8, std::vector<Rgb>(16 * 8, grey(0.2f))});
        picture->pixels[2 * 16 + 5] = grey(sun);
        Environment sky;
        sky.picture = picture;
        SceneMaker maker;
        maker.quad(maker.add(testing::diffuse(grey(0.6f))), {-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0},
                   {-0.5f, 0.5f, 0});
        const Scene scene = maker.make(sky);
        double expected = 0;
        constexpr int kHeights = 500, kTurns = 1000;
        for (int k = 0; k < kHeights * kTurns; ++k) {
            const float z = (static_cast<float>(k / kTurns) + 0.5f) / kHeights;
            const Vec3 way = direction_at(z, (static_cast<float>(k % kTurns) + 0.5f) / kTurns);
            expected +=
                static_cast<double>(0.6f * scene.data().lights.sky(way).radiance.g * 2 * z) / (kHeights * kTurns);
        }
        const Mean mean = along(scene, {{0.1f, 0.2f, 0.8f}, normalized(Vec3{0.1f, 0, -1})}, 20000);
        CAPTURE(sun, expected, mean.value(), mean.error());
        CHECK(mean.value() == Approx(expected).margin(kSigmas * mean.error() + 2e-3 * expected));
    }
}

TEST_CASE("path tracer: white surfaces in white light stay at most white, whatever they are made of")
{
    for (const float alpha : {0.01f, 0.1f, 0.4f, 1.0f}) {
        for (const bool metallic : {false, true}) {
            SceneMaker maker;
            const Material material = metallic ? testing::metal(grey(1), alpha) : testing::glossy(grey(1), alpha);
            maker.ball(maker.add(material), {0, 0, 0.2f}, 0.5f);
            const uint32_t white = maker.add(testing::diffuse(grey(1)));
            maker.quad(white, {-0.6f, -0.6f, -0.4f}, {0.6f, -0.6f, -0.4f}, {0.6f, 0.6f, -0.4f}, {-0.6f, 0.6f, -0.4f});
            const Scene scene = maker.make(constant_environment(1));
            for (const Mean& mean : radiance(PathTracer(scene.data()), 500, 10, 5)) {
                INFO("alpha " << alpha << (metallic ? " metal " : " plastic ") << mean.value() << " ± "
                              << mean.error());
                CHECK(mean.value() <= 1 + kSigmas * mean.error() + 1e-5);
            }
        }
    }
}

TEST_CASE("path tracer: a patch under a rectangular lamp has the closed form's radiance")
{
    constexpr float kHeight = 0.5f, kLight = 3, kAlbedo = 0.5f;
    for (const float half : {0.05f, 0.2f, 0.6f}) {
        SceneMaker maker;
        const uint32_t floor = maker.add(testing::diffuse(grey(kAlbedo)));
        maker.quad(floor, {-0.2f, -0.2f, 0}, {0.2f, -0.2f, 0}, {0.2f, 0.2f, 0}, {-0.2f, 0.2f, 0});
        const uint32_t light = maker.add(testing::lamp(grey(kLight)));
        maker.quad(light, {-half, -half, kHeight}, {half, -half, kHeight}, {half, half, kHeight},
                   {-half, half, kHeight});
        maker.span_unit_sphere();
        const Scene scene = maker.make(constant_environment(0));
        REQUIRE(static_cast<double>(scene.radius()) == Approx(1).epsilon(1e-5));

        // Form factor of a parallel rectangle over a point, four times the corner formula (Howell, "A Catalog of
        // Radiation Heat Transfer Configuration Factors", B-3).
        const double a = static_cast<double>(half / kHeight);
        const double root = std::sqrt(1 + a * a);
        const double form_factor = 4 / (2 * static_cast<double>(kPi)) * 2 * (a / root * std::atan(a / root));
        const double expected = static_cast<double>(kAlbedo * kLight) * form_factor;

        const Vec3 start = {0.75f, 0.003f, 0.1f};
        const Mean mean = along(scene, {start, normalized(Vec3{} - start)}, 20000);
        INFO("half side " << half << ": " << mean.value() << " for " << expected << " ± " << mean.error());
        CHECK(mean.value() == Approx(expected).margin(kSigmas * mean.error() + 2e-4 * expected));
        CHECK(mean.error() < 0.02 * expected);
    }
}

// Every bounce adds albedo times what the last one added: a geometric series that sees any error in long paths.
TEST_CASE("path tracer: inside a closed glowing room radiance is emission / (1 - albedo)")
{
    for (const float albedo : {0.0f, 0.5f, 0.8f}) {
        SceneMaker maker;
        Material wall = testing::diffuse(grey(albedo));
        wall.emission = grey(1);
        maker.box(maker.add(wall), {-0.5f, -0.4f, -0.3f}, {0.5f, 0.4f, 0.3f});
        const Scene scene = maker.make(constant_environment(0));
        const Mean mean = along(scene, {{0.1f, 0, 0}, normalized(Vec3{0.3f, 0.5f, -0.4f})}, 40000);
        const double expected = 1 / (1 - static_cast<double>(albedo));
        INFO("albedo " << albedo << ": " << mean.value() << " for " << expected << " ± " << mean.error());
        CHECK(mean.value() == Approx(expected).margin(kSigmas * mean.error() + 2e-4 * expected));
        CHECK(mean.error() < 0.01 * expected);
    }
}

// Light comes to the body through the glass, where no path can aim at it: roulette that ends a path as it leaves the
// glass makes those that are left as many times brighter.
TEST_CASE("path tracer: roulette ends no path between a dark body and the glass around it")
{
    constexpr uint32_t kPaths = 2000;
    SceneMaker maker;
    maker.ball(maker.add(testing::glass(1.5f, 0)), {}, 0.6f);
    maker.ball(maker.add(testing::diffuse(grey(0.05f))), {}, 0.3f);
    const Scene scene = maker.make(constant_environment(1));
    const PathTracer tracer(scene.data());
    uint32_t bring_nothing = 0;
    for (uint32_t k = 0; k < kPaths; ++k) {
        Sampler sampler(21, k, 0);
        bring_nothing += is_black(tracer.trace({{2, 0.01f, 0.02f}, {-1, 0, 0}}, sampler).radiance);
    }
    // A few meet the body three times, because glass sends their light back to it.
    INFO(bring_nothing << " of " << kPaths);
    CHECK(bring_nothing < kPaths / 10);
}

// Chosen without regard to where they are, a thousand small lamps around a ball still give what looking for them gives.
TEST_CASE("path tracer: the sky is not seen, a pane covers by its opacity")
{
    Material pane = testing::diffuse(grey(0.5f));
    pane.opacity = 0.3f;
    const Scene scene = square_of(pane);
    const PathTracer tracer(scene.data());
    Mean covered;
    for (uint32_t k = 0; k < 10000; ++k) {
        Sampler sampler(1, k, 0);
        covered.add(tracer.trace({{0.1f, 0.1f, 1}, {0, 0, -1}}, sampler).covered ? 1 : 0);
        const PathResult beside = tracer.trace({{0.1f, 0.1f, 1}, {1, 0, 0}}, sampler);
        REQUIRE_FALSE(beside.covered);
        REQUIRE(is_black(beside.radiance));
    }
    CHECK(covered.value() == Approx(0.3).margin(kSigmas * covered.error()));
}

TEST_CASE("path tracer: a pane colours what lies behind once, in place, and mirrors what it does not let in")
{
    SceneMaker maker;
    Material pane = testing::glossy(grey(0.5f), 0.01f);
    pane.thin = true;
    pane.tint = {0.2f, 0.7f, 0.3f};
    const float f0 = 0.04f;  // of the index 1.5
    pane.finish();
    const uint32_t glass = maker.add(pane), lamp = maker.add(testing::lamp(grey(1)));
    maker.quad(glass, {-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0});
    maker.quad(lamp, {-0.1f, -0.1f, -0.5f}, {0.1f, -0.1f, -0.5f}, {0.1f, 0.1f, -0.5f}, {-0.1f, 0.1f, -0.5f});
    const Scene scene = maker.make(constant_environment(0));
    for (const float side : {1.0f, -1.0f}) {  // from behind, the lamp is mirrored
        const Ray ray = {{0.02f, 0.01f, side * (side > 0 ? 0.9f : 0.2f)}, {0, 0, -side}};
        const Mean seen = along(scene, ray, 20000);
        CHECK(seen.value() == Approx(side > 0 ? 0.7 * (1 - static_cast<double>(f0)) : static_cast<double>(f0))
                                  .margin(kSigmas * seen.error() + 0.003));
    }
    const Scene in_light = square_of(pane);
    Mean mirrored = along(in_light, {{0, 0, 0.9f}, {0, 0, -1}}, 20000);
    // The light behind is not seen by the eye: only what is mirrored, and all of it.
    CHECK(mirrored.value() == Approx(static_cast<double>(f0)).margin(kSigmas * mirrored.error() + 0.002));
}

TEST_CASE("path tracer: normal maps neither lose light of a white metal nor make any")
{
    for (const float alpha : {0.01f, 0.25f, 1.0f}) {
        for (const float tilt : {0.3f, 0.8f, 0.99f}) {
            SceneMaker maker;
            const uint32_t white = maker.add(testing::metal(grey(1), alpha));
            maker.quad(white, {-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0});
            maker.tilt_normals(white, tilt);
            const Scene scene = maker.make(constant_environment(1));
            for (const float slope : {-0.9f, -0.3f, 0.5f}) {
                INFO("alpha " << alpha << ", tilt " << tilt << ", slope " << slope);
                const Vec3 way = normalized(Vec3{slope, 0, -0.4f});
                const Mean seen = along(scene, {Vec3{0, 0, 0} - way * 0.9f, way}, 4000);
                CHECK(seen.value() <= 1.02 + kSigmas * seen.error());
                CHECK(seen.value() >= 0.98 - kSigmas * seen.error());
            }
        }
    }
}

TEST_CASE("path tracer: what a matt surface would send is all of its light, nothing of a mirror's, and no view's own")
{
    const auto mean_of = [](const Material& material, const Vec3& from, bool matt) {
        const Scene scene = square_of(material);
        const PathTracer tracer(scene.data());
        Mean mean;
        for (uint32_t k = 0; k < 4000; ++k) {
            Sampler sampler(1, k, 0);
            const PathResult path = tracer.trace({from, normalized(-from)}, sampler);
            mean.add((matt ? path.matt : path.radiance).g);
        }
        return mean.value();
    };
    const Vec3 above = {0, 0, 1}, aside = {0.8f, 0, 0.6f};
    const Material plain = testing::diffuse(grey(0.5f)), plastic = testing::glossy(grey(0.5f), 0.1f);
    CHECK(mean_of(plain, above, true) == Approx(mean_of(plain, above, false)));
    CHECK(mean_of(testing::metal(grey(0.9f), 0.01f), above, true) == 0);
    CHECK(mean_of(plastic, above, true) == Approx(mean_of(plastic, aside, true)).epsilon(0.02));
    CHECK(mean_of(plastic, above, true) == Approx(mean_of(plain, above, true)).epsilon(0.02));
    CHECK(mean_of(plastic, aside, false) > mean_of(plastic, above, false));
    Material pane = plastic;
    pane.thin = true;
    pane.finish();
    CHECK(mean_of(pane, above, true) == 0);  // all that does not mirror passes
    pane.transmission = 0.5f;
    pane.finish();
    CHECK(mean_of(pane, above, true) > 0);
}

// The slope of log error against log samples, by least squares over five doublings of four. Sobol' points may only
// steepen it.
TEST_CASE("path tracer: the error falls as one over the root of the number of samples, or faster")
{
    SceneMaker maker;
    add_room(maker);
    maker.ball(maker.add(testing::glossy({0.2f, 0.4f, 0.6f}, 0.2f)), {0.2f, 0, -0.3f}, 0.2f, 8);
    const Scene scene = maker.make(gradient_environment());
    const PathTracer tracer(scene.data());
    const Vec3 start = {0.1f, -1.2f, 0.2f};
    const Ray ray = {start, normalized(Vec3{0.1f, 0.2f, -0.5f} - start)};
    const auto spread = [&](uint32_t samples, bool independent) {
        Mean means;
        for (uint32_t texel = 0; texel < 400; ++texel) {
            Mean mean;
            Sampler sampler(8, texel, samples);
            for (uint32_t s = 0; s < samples; ++s) {
                if (independent) sampler = Sampler(8, texel * 1000 + s, samples);
                sampler.start(independent ? 0 : s);
                mean.add(static_cast<double>(tracer.trace(ray, sampler).radiance.g));
            }
            means.add(mean.value());
        }
        return means.error();
    };
    for (const bool independent : {true, false}) {
        double sx = 0, sy = 0, sxx = 0, sxy = 0, count = 0;
        for (uint32_t samples = 2; samples <= 128; samples *= 2) {
            const double x = std::log(samples), y = std::log(spread(samples, independent));
            sx += x;
            sy += y;
            sxx += x * x;
            sxy += x * y;
            ++count;
        }
        const double slope = (count * sxy - sx * sy) / (count * sxx - sx * sx);
        INFO((independent ? "independent" : "Sobol") << " slope " << slope);
        // 400 texels tell each error to 3.5 %, and the slope to 0.01.
        CHECK(slope < -0.5 + 0.04);
        CHECK((!independent || slope > -0.5 - 0.04));
    }
}

}  // namespace lumi::baker
