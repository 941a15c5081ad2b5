// SPDX-License-Identifier: MIT
// Extra lights over a white diffuse floor have closed forms.
#include "light/fixtures.h"

#include <catch2/catch.hpp>

#include "math/warp.h"
#include "support/shapes.h"
#include "support/statistics.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{
namespace
{

using testing::kSigmas;
using testing::Mean;
using testing::SceneMaker;

constexpr float kAlbedo = 0.5f;

// A floor through the origin, z up, in the unit sphere.
Scene floor_under(const Fixture& fixture, float exposure = 1)
{
    SceneMaker maker;
    const uint32_t floor = maker.add(testing::diffuse(grey(kAlbedo)));
    maker.quad(floor, {-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0});
    maker.span_unit_sphere();
    maker.add(fixture);
    maker.expose(exposure);
    return maker.make(constant_environment(0));
}

Mean seen_at(const Scene& scene, const Vec3& point, uint32_t paths)
{
    const PathTracer tracer(scene.data());
    const Vec3 start = {0.7f, 0.1f, 0.15f};
    Mean mean;
    for (uint32_t k = 0; k < paths; ++k) {
        Sampler sampler(3, k, 0);
        mean.add(static_cast<double>(tracer.trace({start, normalized(point - start)}, sampler).radiance.g));
    }
    return mean;
}

void check_radiance(const Fixture& fixture, const Vec3& point, double irradiance)
{
    const Mean mean = seen_at(floor_under(fixture), point, 20000);
    const double expected = irradiance * static_cast<double>(kAlbedo / kPi);
    INFO(mean.value() << " ± " << mean.error() << " for " << expected);
    CHECK(mean.value() == Approx(expected).margin(kSigmas * mean.error() + 1e-3 * expected + 1e-9));
}

}  // namespace

TEST_CASE("fixtures: a point light's irradiance falls with the square of the distance and the cosine")
{
    const PointLight light = {{0.2f, 0, 0.5f}, {3, 2, 1}};
    const double d2 = 0.2 * 0.2 + 0.25;
    check_radiance(light, {0, 0, 0}, 2 / d2 * 0.5 / std::sqrt(d2));
    check_radiance(PointLight{{2, 0, 20}, grey(400)}, {0, 0, 0}, 400 * 20 / std::pow(404, 1.5));
}

TEST_CASE("fixtures: a spot is full inside its inner angle, dark outside its outer one, smooth between")
{
    const float inner = std::cos(0.2f), outer = std::cos(0.6f);
    const SpotLight light = {{0, 0, 0.5f}, {0, 0, -1}, inner, outer, grey(1)};
    check_radiance(light, {0, 0, 0}, 4);
    check_radiance(light, {0.4f, 0, 0}, 0);
    const double tangent = std::tan(0.4), d2 = 0.25 * (1 + tangent * tangent);
    const double t = (std::cos(0.4) - static_cast<double>(outer)) / static_cast<double>(inner - outer);
    check_radiance(light, {0.5f * static_cast<float>(tangent), 0, 0}, t * t * (3 - 2 * t) * std::cos(0.4) / d2);
}

TEST_CASE("fixtures: a directional light gives its irradiance times the cosine")
{
    const Vec3 towards = normalized(Vec3{1, 2, 2});
    check_radiance(DirectionalLight{towards, grey(1.5f)}, {0.1f, 0.1f, 0}, 1.5 * 2 / 3);
    check_radiance(DirectionalLight{-towards, grey(1.5f)}, {0.1f, 0.1f, 0}, 0);
}

// A sphere wholly above the horizon: E = πL·sin²(half angle)·cos(direction).
TEST_CASE("fixtures: a spherical light over a plane has the closed form's irradiance, near, far and tiny")
{
    for (const float radius : {1e-3f, 0.1f, 0.39f}) {
        const Vec3 centre = {0.2f, 0, 0.4f};
        const double d2 = 0.2 * 0.2 + 0.4 * 0.4;
        const double sine2 = static_cast<double>(radius * radius) / d2;
        const float radiance = 0.5f / (radius * radius);
        check_radiance(SphereLight{centre, radius, grey(radiance)}, {0, 0, 0},
                       static_cast<double>(kPi * radiance) * sine2 * 0.4 / std::sqrt(d2));
    }
}

// Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", B-3, four corners.
TEST_CASE("fixtures: a rectangle over a plane has the closed form's irradiance, and shines to one side only")
{
    const float half = 0.3f, height = 0.5f;
    const double a = static_cast<double>(half / height), root = std::sqrt(1 + a * a);
    const double form_factor = 4 / (2 * static_cast<double>(kPi)) * 2 * (a / root * std::atan(a / root));
    RectangleLight light = {{-half, -half, height}, {0, 2 * half, 0}, {2 * half, 0, 0}, grey(2)};
    check_radiance(light, {0, 0, 0}, 2 * static_cast<double>(kPi) * form_factor);
    std::swap(light.side_u, light.side_v);
    check_radiance(light, {0, 0, 0}, 0);
}

TEST_CASE(
    "fixtures: a panel is as powerful from whichever corner it is described, and does not shine at its own corner")
{
    const Vec3 corner = {3, 0, -1}, u = {0, 1, 0}, v = {0, 0, 4};
    const Fixtures panel({RectangleLight{corner, u, v, grey(2)}}), turned({RectangleLight{corner + v, u, -v, grey(2)}});
    CHECK(panel.power() == Approx(turned.power()));
    const LightSample s = panel.sample(corner, 0.5f, {0, 0});
    CHECK(s.pdf == 0);
    CHECK(s.distance == 0);
    CHECK(s.direction.x == 0);
}

TEST_CASE("fixtures: the exposure multiplies every light")
{
    const PointLight light = {{0, 0, 0.5f}, grey(1)};
    const double plain = seen_at(floor_under(light), {}, 100).value();
    CHECK(seen_at(floor_under(light, 4), {}, 100).value() == Approx(4 * plain).epsilon(1e-5));
}

TEST_CASE("fixtures: what rays find and what samples say agree in radiance and density")
{
    const Fixtures lights({SphereLight{{0.5f, 0.2f, 0.3f}, 0.2f, grey(3)},
                           RectangleLight{{-0.5f, -0.5f, 0.8f}, {0, 1, 0}, {1, 0, 0}, grey(2)},
                           SphereLight{{0, 0, 0}, 0.9f, grey(0.1f)}});
    Mean density, looked, aimed;
    for (uint32_t k = 0; k < 200000; ++k) {
        Sampler sampler(4, k, 0);
        const Vec3 from = {0.05f, -0.1f, 0.1f};
        const Vec3 direction = square_to_sphere(sampler.next_2d());
        double pdfs = 0, light = 0;
        lights.for_each_seen({from, direction}, [&](const Rgb& radiance, float pdf) {
            pdfs += static_cast<double>(pdf);
            light += static_cast<double>(radiance.g);
        });
        density.add(pdfs * 4 * static_cast<double>(kPi));
        looked.add(light * 4 * static_cast<double>(kPi));
        const float u = sampler.next_1d();
        const LightSample s = lights.sample(from, u, sampler.next_2d());
        aimed.add(static_cast<double>(s.radiance.g / s.pdf));
    }
    INFO(density.value() << " " << looked.value() << " " << aimed.value());
    CHECK(std::abs(density.value() - 1) < kSigmas * density.error());
    CHECK(std::abs(looked.value() - aimed.value()) < kSigmas * std::hypot(looked.error(), aimed.error()));
}

// Ten thousand lamps, of which most are dim: chosen by power they converge like one.
TEST_CASE("lights: ten thousand emissive triangles converge to what one lamp of their mean gives")
{
    constexpr int kSide = 71;
    const auto scene_of = [](int side) {
        SceneMaker maker;
        const uint32_t floor = maker.add(testing::diffuse(grey(kAlbedo)));
        maker.quad(floor, {-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0});
        const uint32_t bright = maker.add(testing::lamp(grey(side == 1 ? 1.0f : 10.0f)));
        const uint32_t dim = maker.add(testing::lamp(grey(side == 1 ? 1.0f : 0.1f)));
        const float step = 1.0f / static_cast<float>(side);
        for (int k = 0; k < side * side; ++k) {
            const float x = static_cast<float>(k % side) * step - 0.5f, y = static_cast<float>(k / side) * step - 0.5f;
            maker.quad(k % 11 == 0 ? bright : dim, {x, y, 0.5f}, {x + step, y, 0.5f}, {x + step, y + step, 0.5f},
                       {x, y + step, 0.5f});
        }
        maker.span_unit_sphere();
        return maker.make(constant_environment(0));
    };
    const Scene many = scene_of(kSide), one = scene_of(1);
    REQUIRE(many.light_count() > 10000);
    const Mean grain = seen_at(many, {}, 40000), whole = seen_at(one, {}, 40000);
    const double mean_radiance = (10 + 0.1 * 10) / 11;
    INFO(grain.value() << " ± " << grain.error() << ", " << whole.value() * mean_radiance << " ± " << whole.error());
    // Each eleventh lamp is bright: the floor sees their mean to some parts in ten thousand.
    CHECK(grain.value() ==
          Approx(whole.value() * mean_radiance).margin(kSigmas * std::hypot(grain.error(), whole.error()) + 2e-3));
    // Directions that the floor draws meet bright lamps and dim ones, which costs some noise.
    CHECK(grain.error() < 1.6 * whole.error());
}

}  // namespace lumi::baker
