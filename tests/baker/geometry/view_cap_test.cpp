// SPDX-License-Identifier: MIT
#include "geometry/view_cap.h"

#include <catch2/catch.hpp>

#include "fit/sample_tracer.h"
#include "math/sampler.h"
#include "math/warp.h"
#include "support/bake_scenes.h"
#include "support/surfaces.h"

namespace lumi::baker::testing
{
namespace
{

Vec3 place_in_ball(Sampler& sampler)
{
    return square_to_sphere(sampler.next_2d()) * sampler.next_1d();
}

// Walks along the line, from where it enters the sphere to far away.
float highest_eye(const Ray& line)
{
    constexpr int kSteps = 4000;
    const float along = dot(line.origin, line.direction);
    const float half = std::sqrt(std::max(0.0f, 1 - dot(line.origin, line.origin) + along * along));
    float highest = -line.direction.z;  // from far away
    for (int k = 0; k < kSteps; ++k) {
        const float way = half + along + 20 * std::pow(static_cast<float>(k) / kSteps, 4.0f);
        highest = std::max(highest, normalized(line.origin - line.direction * way).z);
    }
    return highest;
}

// How many triangles of a box that stands in the sphere face down.
uint32_t bottom_triangles(float cap)
{
    SceneMaker maker;
    maker.box(maker.add(diffuse(grey(0.5f))), {-0.4f, -0.4f, -0.4f}, {0.4f, 0.4f, 0.4f});
    MeshSettings settings = {200, 0.3f, 0.7f};
    settings.cap = ViewCap(cap);
    const BuiltMesh surface = built_mesh(maker.make(constant_environment(1)), settings);
    CHECK(surface.loss.holes == 0);
    CHECK(surface.loss.missed < 1e-3);
    const Mesh mesh = triangles_of(surface.mesh);
    uint32_t count = 0;
    for (size_t k = 0; k < mesh.triangle_count(); ++k) count += normalized(mesh.area_vector(k)).z < -0.9f ? 1u : 0u;
    return count;
}

}  // namespace

TEST_CASE("A cap holds the lines on which one of its eyes lies", "[surface]")
{
    Sampler sampler(1, 2, 3);
    int judged = 0, seen = 0;
    for (uint32_t k = 0; k < 3000; ++k) {
        sampler.start(k);
        const float share = 0.02f + 0.96f * sampler.next_1d();
        const ViewCap cap(share);
        const Ray line = {place_in_ball(sampler), square_to_sphere(sampler.next_2d())};
        const float margin = highest_eye(line) - cap.lowest();
        if (std::abs(margin) > 2e-3f) {  // the walk's steps
            CHECK(cap.sees(line) == (margin > 0));
            ++judged;
            seen += margin > 0 ? 1 : 0;
        }
    }
    CHECK(judged > 2900);
    CHECK(seen > 1000);
    CHECK(judged - seen > 500);
}

TEST_CASE("A surface mesh leaves out what no eye of its cap sees, and that alone", "[surface]")
{
    CHECK(bottom_triangles(1) > 8);
    CHECK(bottom_triangles(0.5f) == 0);
    CHECK(bottom_triangles(0.2f) == 0);
    CHECK(bottom_triangles(0.9f) > 8);
}

TEST_CASE("Light is traced along lines of the cap alone", "[surface]")
{
    const Scene scene = tiny_scene();
    MeshSettings settings = {60, 0.6f, 0.7f};
    settings.cap = ViewCap(0.3f);
    const PatchMesh mesh = built_mesh(scene, settings).mesh;
    const FitShape shape(mesh, std::vector<float>(mesh.patches.size(), 6));
    const auto paths = [&](const SampleTracer& tracer) {
        std::vector<FitSample> samples;
        for (uint32_t p = 0; p < mesh.patches.size(); ++p)
            for (uint32_t t = 0; t < shape.layout.rectangles[p].size(); ++t) tracer.trace(1, p, t, 16, samples);
        return samples.size();
    };
    const size_t all = paths(SampleTracer(scene.data(), shape)),
                 some = paths(SampleTracer(scene.data(), shape, settings.cap));
    CHECK(some > 100);
    CHECK(some < all);
}

}  // namespace lumi::baker::testing
