// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "guided/mean_fit.h"
#include "image/k_means.h"
#include "math/sampler.h"
#include "proxy/proxy_fit.h"
#include "proxy/proxy_outside.h"
#include "proxy/proxy_simplify.h"
#include "support/shapes.h"

namespace lumi::baker::testing
{
namespace
{

const ProgressCallback kSilent;

Mesh plate()
{
    Mesh mesh;
    mesh.positions = {{-0.5f, -0.5f, 0.1f}, {0.5f, -0.5f, 0.1f}, {0.5f, 0.5f, 0.1f}, {-0.5f, 0.5f, 0.1f}};
    mesh.corners = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

// The mean difference between the depths that both the scene and the mesh have, in radii.
double mean_depth_error(const Survey& survey, const Mesh& mesh)
{
    const ProxyTracer tracer(mesh, false);
    uint32_t both = 0;
    double sum = 0;
    for (uint32_t i = 0; i < survey.origins(); ++i) {
        for (const SurveyRay& r : survey.look(i, tracer)) {
            if (r.proxy && std::isfinite(r.scene)) {
                ++both;
                sum += static_cast<double>(std::abs(r.scene - r.proxy->distance));
            }
        }
    }
    return sum / std::max(both, 1u);
}

Scene box_with(bool ball_inside)
{
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    maker.box(matter, {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
    if (ball_inside) {
        maker.ball(matter, {0, 0, 0}, 0.3f, 8);
    }
    return maker.make(constant_environment(1));
}

}  // namespace

TEST_CASE("Mean colours follow what is linear in space, and fill nodes that no point tells about", "[guided]")
{
    const NodeGrid grid(plate(), 24);
    const auto colour_at = [](const Vec3& x) { return Levels{100 + 80 * x.x, 120 - 60 * x.y, 50}; };
    MeanFit fit(grid);
    Sampler sampler(3, 0, 0);
    for (uint32_t k = 0; k < 8000; ++k) {
        sampler.start(k);
        const Vec2 u = sampler.next_2d();
        const Vec3 x = {u.x - 0.5f, u.y - 0.5f, 0.1f};
        if (std::hypot(x.x, x.y) > 0.1f) {  // a hole without points
            fit.add(x, colour_at(x));
        }
    }
    const std::vector<Levels> colours = fit.solve();
    double worst = 0, worst_in_hole = 0;
    for (uint32_t k = 0; k < 2000; ++k) {
        sampler.start(k);
        const Vec2 u = sampler.next_2d();
        const Vec3 x = {0.94f * (u.x - 0.5f), 0.94f * (u.y - 0.5f), 0.1f};
        const Levels d = trilinear(grid, colours, x) - colour_at(x);
        double& w = std::hypot(x.x, x.y) > 0.15f ? worst : worst_in_hole;
        w = std::max(w, static_cast<double>(std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)})));
    }
    CHECK(worst < 1);
    CHECK(worst_in_hole < 8);
}

TEST_CASE("k-means finds clusters that lie apart, and keeps fixed centres", "[guided]")
{
    std::vector<ColourPoint> points;
    for (int k = 0; k < 300; ++k) {
        points.push_back({static_cast<float>(100 * (k % 3)), static_cast<float>(k / 3 % 5), 0, 0});
    }
    const std::vector<ColourPoint> centres = k_means(points, {{-50, 0, 0, 0}}, 4, 1);
    REQUIRE(centres.size() == 4);
    CHECK(centres[0] == ColourPoint{-50, 0, 0, 0});
    for (const ColourPoint& p : points) {
        CHECK(nearest_centre(centres, p).distance2 < 4.1f);
    }
    CHECK(k_means(points, {}, 200, 1).size() == 15);  // no more than there are different points
    CHECK(k_means({}, {}, 16, 1).empty());
}

TEST_CASE("Simplified balls stay balls, and fitting brings them closer", "[guided]")
{
    SceneMaker maker;
    maker.ball(maker.add(diffuse(grey(0.5f))), {0, 0, 0}, 0.8f, 48);
    maker.span_unit_sphere();
    const Scene scene = maker.make(constant_environment(1));
    Job job(1, 2, kSilent);
    const Outside outside = outside_of(scene.data(), job);
    CHECK_FALSE(outside.two_sided);
    CHECK(outside.mesh.triangle_count() == scene.triangle_count());
    const Mesh rough = simplified(outside.mesh, 200);
    CHECK(rough.triangle_count() <= 200);
    CHECK(rough.triangle_count() > 150);
    const Survey survey(scene.data(), 64, 300, 5);
    const Mesh fine = fitted(rough, false, survey, job);
    CHECK(mean_depth_error(survey, fine) < 0.6 * mean_depth_error(survey, rough));
}

TEST_CASE("What nobody can see is no part of the proxy", "[guided]")
{
    const Scene alone = box_with(false), filled = box_with(true);
    Job job(1, 2, kSilent);
    CHECK(filled.triangle_count() > alone.triangle_count());
    CHECK(outside_of(filled.data(), job).mesh.triangle_count() == outside_of(alone.data(), job).mesh.triangle_count());
}

TEST_CASE("Boxes wound inside out are turned", "[guided]")
{
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    maker.box(matter, {0.5f, -0.5f, -0.5f}, {-0.5f, 0.5f, 0.5f});  // mirrored
    const Scene scene = maker.make(constant_environment(1));
    Job job(1, 2, kSilent);
    const Outside outside = outside_of(scene.data(), job);
    CHECK_FALSE(outside.two_sided);
    const ProxyTracer tracer(outside.mesh, false);
    for (const float x : {-1.0f, 1.0f}) {
        const std::optional<Hit> hit = tracer.closest({{x, 0.01f, 0.02f}, {-x, 0, 0}});
        REQUIRE(hit);
        CHECK(hit->distance < 1);  // the near face
    }
}

}  // namespace lumi::baker::testing
