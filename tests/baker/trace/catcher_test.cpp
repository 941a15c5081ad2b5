// SPDX-License-Identifier: MIT
// Shadow catchers: closed forms, a second estimator, and who may see them.
#include "trace/catcher.h"

#include <catch2/catch.hpp>

#include "chord/texel_tracer.h"
#include "lumi/baker/surface.h"
#include "math/warp.h"
#include "scene/scene_fingerprint.h"
#include "support/bake_scenes.h"
#include "support/statistics.h"
#include "trace/hit_point.h"

namespace lumi::baker
{
namespace
{

using testing::kSigmas;
using testing::Mean;
using testing::SceneMaker;

constexpr Disc kFloor = {{0, 0, -0.5f}, 0.8f};

Mean shadow(const Scene& scene, const Vec3& at, uint32_t count)
{
    Mean mean;
    for (uint32_t k = 0; k < count; ++k) {
        Sampler sampler(7, k, 0);
        mean.add(static_cast<double>(shadow_at(scene.data(), at, sampler)));
    }
    return mean;
}

Ray down_to(const Vec3& target)
{
    return {{target.x, target.y, 1}, {0, 0, -1}};
}

// A square plate of side 0.2 that lies level at height 0, in the unit sphere.
SceneMaker plate()
{
    SceneMaker maker;
    maker.span_unit_sphere();
    const uint32_t grey = maker.add(testing::diffuse(baker::grey(0.5f)));
    maker.quad(grey, {-0.1f, -0.1f, 0}, {0.1f, -0.1f, 0}, {0.1f, 0.1f, 0}, {-0.1f, 0.1f, 0});
    maker.catch_shadows(kFloor);
    return maker;
}

// A ball of radius 0.2 in the unit sphere, its lowest point 0.1 above the catcher.
constexpr Vec3 kBallCentre = {0, 0, -0.2f};
constexpr float kBallRadius = 0.2f;

SceneMaker hovering_ball()
{
    SceneMaker maker;
    maker.span_unit_sphere();
    maker.ball(maker.add(testing::diffuse(grey(0.5f))), kBallCentre, kBallRadius, 64);
    maker.catch_shadows(kFloor);
    return maker;
}

// Under every kind of light, with something that is half transparent.
Scene lit_room()
{
    SceneMaker maker = hovering_ball();
    maker.add(SphereLight{{0.5f, 0.2f, 0.6f}, 0.15f, {8, 6, 4}});
    maker.add(RectangleLight{{-0.7f, -0.5f, 0.1f}, {0, 1, 0}, {0, 0, 0.4f}, grey(3)});
    const uint32_t lamp = maker.add(testing::lamp({9, 8, 7}));
    maker.quad(lamp, {-0.3f, 0.3f, 0.4f}, {0.1f, 0.3f, 0.4f}, {0.1f, 0.6f, 0.4f}, {-0.3f, 0.6f, 0.4f});
    Material pane = testing::diffuse({0.3f, 0.5f, 0.3f});
    pane.opacity = 0.4f;
    maker.quad(maker.add(pane), {0.3f, -0.4f, -0.45f}, {0.3f, 0.4f, -0.45f}, {0.3f, 0.4f, 0.2f}, {0.3f, -0.4f, 0.2f});
    return maker.make(studio_environment());
}

// The light that arrives along one ray, with and without what stands in the way.
struct Arriving {
    double shadowed = 0, all = 0;
};

Arriving arriving(const SceneData& scene, const Ray& ray, Sampler& sampler)
{
    Arriving result;
    const auto fixtures = [&](float end) {
        double sum = 0;
        scene.lights.for_each_seen({ray.origin, ray.direction, end},
                                   [&](const Rgb& c, float) { sum += static_cast<double>(luminance(c)); });
        return sum;
    };
    const double sky = static_cast<double>(luminance(scene.lights.sky_radiance(ray.direction)));
    const std::optional<Hit> first = closest_opaque(scene, ray, sampler);
    result.shadowed = first ? fixtures(first->distance) : sky + fixtures(ray.end);
    result.all = sky + fixtures(ray.end);
    return result;
}

// Finds the same share by rays into all directions, which know nothing of lights.
Mean brute_shadow(const SceneData& scene, const Vec3& at)
{
    constexpr uint32_t kRays = 200000, kBatch = 2000;
    Mean mean;
    Arriving sum;
    for (uint32_t k = 0; k < kRays; ++k) {
        Sampler sampler(8, k, 0);
        const Vec3 direction = square_to_cosine_hemisphere(sampler.next_2d());
        const Arriving one = arriving(scene, {at + Vec3{0, 0, 1e-5f}, direction}, sampler);
        sum.shadowed += one.shadowed;
        sum.all += one.all;
        if (k % kBatch == kBatch - 1) {
            mean.add(1 - sum.shadowed / sum.all);
            sum = {};
        }
    }
    return mean;
}

}  // namespace

TEST_CASE("catcher: it is met from above, inside its rim and before the ray's end alone")
{
    const Disc disc = {{0.2f, 0, -0.5f}, 0.5f};
    const Vec3 slanted = normalized({0.3f, 0, -1});
    REQUIRE(distance_to_catcher(disc, {{0, 0, 1}, slanted}));
    CHECK(static_cast<double>(*distance_to_catcher(disc, {{0, 0, 1}, slanted})) ==
          Approx(1.5 * std::sqrt(1 + 0.09)).epsilon(1e-6));
    CHECK(distance_to_catcher(disc, down_to({0.699f, 0, 0})));
    CHECK(distance_to_catcher(disc, down_to({0.2f, -0.499f, 0})));
    CHECK_FALSE(distance_to_catcher(disc, down_to({0.701f, 0, 0})));
    CHECK_FALSE(distance_to_catcher(disc, down_to({-0.301f, 0, 0})));
    CHECK_FALSE(distance_to_catcher(disc, {{0, 0, -1}, {0, 0, 1}}));
    CHECK_FALSE(distance_to_catcher(disc, {{0, 0, -1}, {0, 0, -1}}));
    CHECK_FALSE(distance_to_catcher(disc, {{0, 0, -0.5f}, {1, 0, 0}}));
    CHECK_FALSE(distance_to_catcher(disc, {{0, 0, 1}, {0, 0, -1}, 1.499f}));
    CHECK(distance_to_catcher(disc, {{0, 0, 1}, {0, 0, -1}, 1.501f}));
}

TEST_CASE("catcher: a lamp without size throws a shadow whose edge lies where geometry says")
{
    // Plate 0.5 and lamp 1.5 above the catcher: the shadow's half side is 0.1·1.5/(1.5 - 0.5).
    SceneMaker maker = plate();
    maker.add(PointLight{{0, 0, 1}, grey(3)});
    const Scene scene = maker.make(constant_environment(0));
    constexpr float kEdge = 0.15f, kStep = 0.0005f;
    for (float along = -0.149f; along < 0.15f; along += 0.02f) {
        for (const float side : {-1.0f, 1.0f}) {
            INFO("at " << along << ", side " << side);
            CHECK(shadow(scene, {side * (kEdge - kStep), along, -0.5f}, 16).value() == 1);
            CHECK(shadow(scene, {side * (kEdge + kStep), along, -0.5f}, 16).value() == 0);
            CHECK(shadow(scene, {along, side * (kEdge - kStep), -0.5f}, 16).value() == 1);
            CHECK(shadow(scene, {along, side * (kEdge + kStep), -0.5f}, 16).value() == 0);
        }
    }
}

TEST_CASE("catcher: of two lamps without size the share in shadow is that of their irradiances")
{
    SceneMaker maker = plate();
    maker.add(PointLight{{0, 0, 1}, grey(3)});
    maker.add(DirectionalLight{normalized({1, 0, 1}), {0.2f, 0.4f, 0.6f}});
    const Scene scene = maker.make(constant_environment(0));
    // The plate hides the one; the other's shadow lies at x = -0.5.
    const double hidden = 3 / 1.5 / 1.5, seen = static_cast<double>(luminance({0.2f, 0.4f, 0.6f})) * std::sqrt(0.5);
    const Mean under = shadow(scene, kFloor.centre, 20000);
    CHECK(under.value() == Approx(hidden / (hidden + seen)).margin(0.001 + kSigmas * under.error()));
    const float x = -0.5f;
    const double r2 = 0.25 + 2.25, lamp = 3 * 1.5 / std::pow(r2, 1.5);
    const Mean beside = shadow(scene, {x, 0, -0.5f}, 20000);
    CHECK(beside.value() == Approx(seen / (lamp + seen)).margin(0.001 + kSigmas * beside.error()));
}

TEST_CASE("catcher: under an even sky it shows the ambient occlusion of a ball")
{
    // A ball that subtends the half angle a and lies wholly above the horizon hides cos(elevation from the zenith)·
    // sin²a of an even sky's irradiance.
    const Scene scene = hovering_ball().make(constant_environment(0.8f));
    for (const float x : {0.0f, 0.1f, 0.25f, 0.45f}) {
        const double dx = static_cast<double>(x), dz = 0.3, d2 = dx * dx + dz * dz;
        const double expected = dz / std::sqrt(d2) * 0.04 / d2;
        const Mean mean = shadow(scene, {x, 0, -0.5f}, 200000);
        INFO("at " << x << ": " << mean.value() << " ± " << mean.error() << ", expected " << expected << ", off by "
                   << mean.value() - expected);
        // Flat faces hide a little less than a ball; the rest is the bias of a ratio.
        constexpr double kBias = 0.001;
        CHECK(std::abs(mean.value() - expected) < kBias + kSigmas * mean.error());
        CHECK(mean.error() > 0);
    }
}

TEST_CASE("catcher: aiming at lights and rays into all directions agree on the share in shadow")
{
    const Scene scene = lit_room();
    for (const Vec3& at :
         {Vec3{0, 0, -0.5f}, {0.2f, 0.1f, -0.5f}, {-0.3f, -0.2f, -0.5f}, {-0.5f, 0.3f, -0.5f}, {0.4f, 0, -0.5f}}) {
        const Mean ours = shadow(scene, at, 100000), brute = brute_shadow(scene.data(), at);
        INFO("at " << at.x << ", " << at.y << ": " << ours.value() << " and " << brute.value() << " ± "
                   << brute.error());
        constexpr double kBias = 0.002;  // a ratio of sums over few samples is biased by up to so much
        CHECK(std::abs(ours.value() - brute.value()) < kBias + kSigmas * std::hypot(ours.error(), brute.error()));
        CHECK(brute.value() > 0.02);
    }
}

TEST_CASE("catcher: what objects emit throws no shadows, nor does it lighten any")
{
    SceneMaker glowing = hovering_ball();
    const uint32_t lamp = glowing.add(testing::lamp(grey(50)));
    glowing.quad(lamp, {-0.1f, -0.1f, 0.1f}, {0.1f, -0.1f, 0.1f}, {0.1f, 0.1f, 0.1f}, {-0.1f, 0.1f, 0.1f});
    const Vec3 at = {0.45f, 0, -0.5f};
    SceneMaker alone = glowing;
    CHECK(shadow(alone.make(constant_environment(0)), at, 100).value() == 0);
    SceneMaker black = hovering_ball();
    const uint32_t unlit = black.add(testing::diffuse(grey(0)));
    black.quad(unlit, {-0.1f, -0.1f, 0.1f}, {0.1f, -0.1f, 0.1f}, {0.1f, 0.1f, 0.1f}, {-0.1f, 0.1f, 0.1f});
    const Mean lit = shadow(glowing.make(studio_environment()), at, 20000);
    const Mean dark = shadow(black.make(studio_environment()), at, 20000);
    CHECK(std::abs(lit.value() - dark.value()) < kSigmas * std::hypot(lit.error(), dark.error()));
    CHECK(dark.value() > 0.02);
}

TEST_CASE("catcher: rays are covered by black as often as the share in shadow, else they see what lies behind")
{
    SceneMaker maker = hovering_ball();
    const uint32_t lamp = maker.add(testing::lamp(grey(2)));
    maker.quad(lamp, {-0.4f, -0.1f, -0.8f}, {0.4f, -0.1f, -0.8f}, {0.4f, 0.1f, -0.8f}, {-0.4f, 0.1f, -0.8f});
    const Scene scene = maker.make(constant_environment(1));
    const PathTracer tracer(scene.data());
    const Vec3 at = {0.25f, 0, -0.5f}, beside = {0.25f, 0.2f, -0.5f};
    Mean dark, covered;
    for (uint32_t k = 0; k < 20000; ++k) {
        Sampler sampler(5, k, 0);
        const PathResult path = tracer.trace(down_to(at), sampler);
        REQUIRE(path.covered);
        REQUIRE((is_black(path.radiance) || path.radiance.r == 2));
        dark.add(is_black(path.radiance) ? 1 : 0);
        Sampler other(6, k, 0);
        covered.add(tracer.trace(down_to(beside), other).covered ? 1 : 0);
    }
    const Mean expected = shadow(scene, at, 20000), expected_beside = shadow(scene, beside, 20000);
    CHECK(std::abs(dark.value() - expected.value()) < kSigmas * std::hypot(dark.error(), expected.error()));
    CHECK(std::abs(covered.value() - expected_beside.value()) <
          kSigmas * std::hypot(covered.error(), expected_beside.error()));
    CHECK(expected.value() > 0.1);
}

TEST_CASE("catcher: the objects neither see it nor are they shaded by it")
{
    SceneMaker without;
    without.span_unit_sphere();
    without.ball(without.add(testing::glossy(grey(0.5f), 0.2f)), kBallCentre, kBallRadius, 16);
    SceneMaker with = without;
    with.catch_shadows(kFloor);
    const Scene bare = without.make(studio_environment()), caught = with.make(studio_environment());
    const PathTracer a(bare.data()), b(caught.data());
    for (uint32_t k = 0; k < 500; ++k) {
        Sampler aim(3, k, 0);
        const Vec3 start = square_to_sphere(aim.next_2d());
        const Ray ray = {start, normalized(kBallCentre + square_to_sphere(aim.next_2d()) * 0.15f - start)};
        Sampler one(4, k, 0), two(4, k, 0);
        const PathResult seen = a.trace(ray, one), same = b.trace(ray, two);
        REQUIRE(seen.covered);
        REQUIRE(seen.covered == same.covered);
        REQUIRE(seen.radiance.r == same.radiance.r);
    }
    // From below it is not there: the ball's underside is seen through it.
    Sampler one(4, 0, 0), two(4, 0, 0);
    const Ray up = {{0, 0, -1}, {0, 0, 1}};
    CHECK(a.trace(up, one).radiance.g == b.trace(up, two).radiance.g);
}

TEST_CASE("catcher: without an object above it nothing is covered, whatever the light")
{
    SceneMaker maker;
    maker.span_unit_sphere();
    maker.add(SphereLight{{0.5f, 0.2f, 0.6f}, 0.15f, {8, 6, 4}});
    maker.add(PointLight{{0, 0, 2}, grey(3)});
    maker.catch_shadows({{0, 0, 0}, 0.9f});
    const Scene scene = maker.make(studio_environment());
    const PathTracer tracer(scene.data());
    for (uint32_t k = 0; k < 4000; ++k) {
        Sampler sampler(9, k, 0);
        const Vec2 u = sampler.next_2d();
        const Vec2 disc = square_to_disc(u);
        REQUIRE_FALSE(tracer.trace(down_to({0.85f * disc.x, 0.85f * disc.y, 0}), sampler).covered);
    }
}

TEST_CASE("catcher: what lies on it hides it, and no light at all throws no shadow")
{
    SceneMaker maker;
    maker.span_unit_sphere();
    const uint32_t lamp = maker.add(testing::lamp(grey(2)));
    maker.quad(lamp, {-0.3f, -0.3f, -0.5f}, {0.3f, -0.3f, -0.5f}, {0.3f, 0.3f, -0.5f}, {-0.3f, 0.3f, -0.5f});
    maker.catch_shadows(kFloor);
    const Scene scene = maker.make(constant_environment(0));
    for (uint32_t k = 0; k < 500; ++k) {
        Sampler sampler(2, k, 0);
        const Vec2 u = sampler.next_2d();
        const PathResult path =
            PathTracer(scene.data()).trace(down_to({0.59f * (u.x - 0.5f), 0.59f * (u.y - 0.5f), 0}), sampler);
        REQUIRE(path.covered);
        REQUIRE(path.radiance.r == 2);
    }
    Sampler sampler(2, 0, 0);
    CHECK(shadow_at(hovering_ball().make(constant_environment(0)).data(), kFloor.centre, sampler) == 0);
}

TEST_CASE("catcher: it widens the fitted sphere and must lie in a given one")
{
    SceneMaker maker;
    maker.ball(maker.add(testing::diffuse(grey(0.5f))), {}, 0.5f, 8);
    SceneMaker wide = maker;
    wide.catch_shadows({{0, 0, -0.5f}, 2});
    CHECK(static_cast<double>(maker.make(constant_environment(1)).radius()) == Approx(0.5).epsilon(1e-4));
    const Scene scene = wide.make(constant_environment(1));
    CHECK(static_cast<double>(scene.radius()) == Approx(2).epsilon(0.01));
    const Disc& moved = *scene.data().catcher;
    CHECK(length(moved.centre) + moved.radius <= 1.0f);
    CHECK(static_cast<double>(moved.radius) == Approx(2 / static_cast<double>(scene.radius())));
}

TEST_CASE("catcher: its shadow reaches palette texels as partial coverage, other texels are refused by name")
{
    const Scene scene = hovering_ball().make(constant_environment(1));
    BakeSettings settings = testing::tiny_settings(TexelFormat::palette8);
    settings.origins = settings.directions = 40;
    settings.samples = 16;
    const std::string file = testing::baked(scene, settings);
    const TexelTracer texels(scene.data(), settings);
    int partly = 0;
    for (uint32_t i = 0; i < 40; ++i) {
        for (uint32_t j = 0; j < 40; ++j) {
            const detail::Rgba8 c = texels.estimate(texels.disc(i), i, j).covered_colour();
            partly += c.a > 20 && c.a < 235 && c.r == 0 ? 1 : 0;
        }
    }
    CHECK(partly > 20);
    // Every texel takes all its paths: the first ones may miss a faint shadow.
    settings.samples = 40;
    settings.max_error_levels = 1;
    const TexelTracer patient(scene.data(), settings);
    for (uint32_t j = 0; j < 40; ++j) CHECK(patient.estimate(patient.disc(0), 0, j).samples() == 40);
    for (const auto texel : {TexelFormat::rgb888, TexelFormat::rgb565, TexelFormat::luma8}) {
        CHECK_THROWS_WITH(testing::baked(scene, testing::tiny_settings(texel)),
                          Catch::Contains("'catcher'") && Catch::Contains("--texel palette8"));
    }
    CHECK_THROWS_WITH(surface_field(scene, {}), Catch::Contains("'catcher'") && Catch::Contains("--layout chord"));
}

TEST_CASE("catcher: the fingerprint knows it")
{
    const auto of = [](const std::optional<Disc>& disc) {
        SceneMaker maker;
        maker.span_unit_sphere();
        if (disc) maker.catch_shadows(*disc);
        return scene_fingerprint(maker.make(constant_environment(1)).data());
    };
    CHECK(of(std::nullopt) == of(std::nullopt));
    CHECK(of(kFloor) == of(kFloor));
    CHECK(of(kFloor) != of(std::nullopt));
    CHECK(of(Disc{{0, 0, -0.5f}, 0.79f}) != of(kFloor));
    CHECK(of(Disc{{0, 0, -0.49f}, 0.8f}) != of(kFloor));
}

}  // namespace lumi::baker
