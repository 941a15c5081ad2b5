// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "lumi/detail/lattice.h"
#include "math/vec3.h"
#include "mesh/mesh_fit.h"
#include "mesh/mesh_outline.h"
#include "mesh/outside.h"
#include "mesh/simplify/simplify.h"

#include "support/shapes.h"

namespace lumi::baker::testing
{
namespace
{

const ProgressCallback kUnheard;
constexpr uint32_t kEyes = 50;  // none of the fit's

Vec3 eye_at(uint32_t k)
{
    return unit_vector(lumi::detail::point(detail::Lattice(kEyes), k));
}

Mesh outside_mesh(const Scene& scene)
{
    Job job(1, 2, kUnheard);
    return outside_of(scene.data(), job).mesh;
}

Mesh scaled(Mesh mesh, float factor)
{
    for (Vec3& p : mesh.positions) p = p * factor;
    return mesh;
}

// How far the outline of a mesh lies outside of the scene's, in the mean over all of it and all eyes, in radii: of the
// areas that only one of them covers, the difference and the sum.
struct OutlineError {
    double bias, size;
};

OutlineError outline_error(const Scene& scene, const Mesh& mesh, float outline)
{
    constexpr int kSteps = 400;
    const MeshTracer tracer(mesh, Faces::front);
    int added = 0, missing = 0;
    for (uint32_t k = 0; k < kEyes; ++k) {
        const Frame frame(eye_at(k));
        for (int i = 0; i < kSteps * kSteps; ++i) {
            const auto place = [](int step) { return (2 * static_cast<float>(step) + 1) / kSteps - 1; };
            const Ray ray = {frame.to_world({place(i % kSteps), place(i / kSteps), 2}), -frame.normal};
            const bool in_scene = scene.data().accelerator.blocked(ray), in_mesh = tracer.closest(ray).has_value();
            added += in_mesh && !in_scene ? 1 : 0;
            missing += in_scene && !in_mesh ? 1 : 0;
        }
    }
    const double area = 4.0 / (kSteps * kSteps) / (kEyes * static_cast<double>(outline));
    return {(added - missing) * area, (added + missing) * area};
}

}  // namespace

TEST_CASE("Outlines of a larger or smaller box lie as far from the box's as they are long", "[mesh]")
{
    SceneMaker maker;
    maker.box(maker.add(diffuse(grey(0.5f))), {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
    const Scene scene = maker.make(constant_environment(1));
    const Mesh box = outside_mesh(scene);
    for (const float factor : {0.98f, 1.02f}) {
        const MeshTracer mesh(scaled(box, factor), Faces::front);
        const MeshOutline outline(scene.data(), mesh);
        uint32_t points = 0;
        float worst = 0;
        for (uint32_t k = 0; k < kEyes; ++k) {
            for (const OutlinePoint& p : outline.seen_from(eye_at(k), k)) {
                const Vec3& from = mesh.mesh().positions[p.from];
                const Vec3 along = mesh.mesh().positions[p.to] - from;
                // Beside corners another edge may be nearer; along edges that lead away depth changes.
                constexpr float kAcross = 0.7f, kEnd = 0.2f;
                if (length(cross(along, eye_at(k))) < kAcross * length(along)) continue;
                if (std::abs(p.share - 0.5f) > 0.5f - kEnd) continue;
                const float truth = dot(p.outwards, from) * (1 / factor - 1);
                worst = std::max(worst, std::abs(p.offset - truth));
                ++points;
            }
        }
        CHECK(points > 20 * kEyes);
        CHECK(worst < 5e-4f);  // bisection ends below 0.02/64
    }
}

TEST_CASE("The border of a sheet is an outline from in front and from behind", "[mesh]")
{
    constexpr float kHalf = 0.5f, kFactor = 0.98f;
    SceneMaker maker;
    maker.quad(maker.add(diffuse(grey(0.5f))), {-kHalf, -kHalf, 0}, {kHalf, -kHalf, 0}, {kHalf, kHalf, 0},
               {-kHalf, kHalf, 0});
    const Scene scene = maker.make(constant_environment(1));
    const MeshTracer mesh(scaled(outside_mesh(scene), kFactor), Faces::both);
    for (const float side : {1.0f, -1.0f}) {
        const std::vector<OutlinePoint> points = MeshOutline(scene.data(), mesh).seen_from({0, 0, side}, 1);
        CHECK(points.size() > 180);  // 4 edges, a point every 0.02
        for (const OutlinePoint& p : points) {
            const Vec3& from = mesh.mesh().positions[p.from];
            CHECK(std::abs(p.offset - dot(p.outwards, from) * (1 / kFactor - 1)) < 5e-4f);
            CHECK(dot(p.outwards, from) > 0);
        }
    }
}

TEST_CASE("Both sides of a gap in a mesh come half of the way where the scene goes on", "[mesh]")
{
    constexpr float kTop = 0.5f, kHalfGap = 0.01f;
    SceneMaker maker;
    maker.box(maker.add(diffuse(grey(0.5f))), {-kTop, -kTop, -kTop}, {kTop, kTop, kTop});
    const Scene scene = maker.make(constant_environment(1));
    Mesh halves;  // the two halves of the box's top
    const auto add_half = [&](float left, float right) {
        const uint32_t k = static_cast<uint32_t>(halves.positions.size());
        for (const float x : {left, right})
            for (const float y : {-kTop, kTop}) halves.positions.push_back({x, y, kTop});
        halves.corners.push_back({k, k + 2, k + 3});
        halves.corners.push_back({k, k + 3, k + 1});
    };
    add_half(-kTop, -kHalfGap);
    add_half(kHalfGap, kTop);
    const MeshTracer mesh(halves, Faces::front);
    uint32_t beside_gap = 0;
    for (const OutlinePoint& p : MeshOutline(scene.data(), mesh).seen_from({0, 0, 1}, 1)) {
        const bool is_gap = std::abs(mesh.mesh().positions[p.from].x) < 2 * kHalfGap &&
                            std::abs(mesh.mesh().positions[p.to].x) < 2 * kHalfGap;
        CHECK(std::abs(p.offset - (is_gap ? kHalfGap : 0)) < 5e-4f);
        beside_gap += is_gap ? 1 : 0;
    }
    CHECK(beside_gap > 80);  // 2 edges of length 1, a point every 0.02
}

TEST_CASE("Fitting brings the outline of a ball of few triangles onto the ball's", "[mesh]")
{
    constexpr float kRadius = 0.8f;
    SceneMaker maker;
    maker.ball(maker.add(diffuse(grey(0.5f))), {0, 0, 0}, kRadius, 48);
    maker.span_unit_sphere();
    const Scene scene = maker.make(constant_environment(1));
    const Mesh rough = simplified(outside_mesh(scene), 200);
    Job job(1, 2, kUnheard);
    const Mesh fine = fitted_in_rounds(scene.data(), rough, Faces::front, job);
    const OutlineError before = outline_error(scene, rough, 2 * kPi * kRadius);
    const OutlineError after = outline_error(scene, fine, 2 * kPi * kRadius);
    UNSCOPED_INFO("before " << before.bias << " of " << before.size << ", after " << after.bias << " of "
                            << after.size);
    CHECK(before.bias < -0.01);
    CHECK(std::abs(after.bias) < 0.002);  // 0.0038 by depths alone
    CHECK(after.size < 0.5 * before.size);
}

}  // namespace lumi::baker::testing
