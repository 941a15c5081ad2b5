// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "proxy/proxy_fit.h"
#include "proxy/proxy_outside.h"
#include "proxy/proxy_simplify.h"
#include "support/shapes.h"

namespace lumi::baker::testing
{
namespace
{

const ProgressCallback kSilent;

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

TEST_CASE("Simplified balls stay balls, and fitting brings them closer", "[proxy]")
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
    const Mesh fine = fitted(rough, rough, false, survey, job);
    CHECK(mean_depth_error(survey, fine) < 0.6 * mean_depth_error(survey, rough));
}

TEST_CASE("What nobody can see is no part of the proxy", "[proxy]")
{
    const Scene alone = box_with(false), filled = box_with(true);
    Job job(1, 2, kSilent);
    CHECK(filled.triangle_count() > alone.triangle_count());
    CHECK(outside_of(filled.data(), job).mesh.triangle_count() == outside_of(alone.data(), job).mesh.triangle_count());
}

TEST_CASE("Boxes wound inside out are turned", "[proxy]")
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
