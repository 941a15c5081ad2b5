// SPDX-License-Identifier: MIT
// Silhouettes of surface meshes against those of their scenes, from all around.
#include <catch2/catch.hpp>

#include "math/vec3.h"
#include "math/warp.h"
#include "support/shapes.h"
#include "support/surfaces.h"

namespace lumi::baker::testing
{
namespace
{

constexpr int kRound = 64;  // steps around

// A tube along a part of a circle in the plane y = 0, from turn to turn; closed where it is the whole circle.
void add_ring(SceneMaker& maker, uint32_t material, const Vec3& centre, const Vec2& radii, const Vec2& turns)
{
    const auto at = [&](int along, int around) {
        const float t = turns.x + (turns.y - turns.x) * static_cast<float>(along) / kRound;
        const Vec3 out = {std::cos(2 * kPi * t), 0, std::sin(2 * kPi * t)};
        const float a = 2 * kPi * static_cast<float>(around % kRound) / kRound;
        return centre + out * (radii.x + radii.y * std::cos(a)) + Vec3{0, radii.y * std::sin(a), 0};
    };
    for (int i = 0; i < kRound; ++i)
        for (int j = 0; j < kRound; ++j) maker.quad(material, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
}

// A ball without its cap above the height `mouth` (of its radius).
void add_open_ball(SceneMaker& maker, uint32_t material, float radius, float mouth, bool inwards)
{
    const auto at = [&](int ring, int step) {
        const float z = -1 + (1 + mouth) * static_cast<float>(ring) / kRound;
        return direction_at(z, static_cast<float>(step % kRound) / kRound) * radius;
    };
    for (int ring = 1; ring < kRound; ++ring) {
        for (int step = 0; step < kRound; ++step) {
            const int a = inwards ? step + 1 : step, b = inwards ? step : step + 1;
            maker.quad(material, at(ring, a), at(ring, b), at(ring + 1, b), at(ring + 1, a));
        }
    }
    for (int step = 0; step < kRound; step += 2) {
        const int a = inwards ? step : step + 2, b = inwards ? step + 2 : step;
        maker.quad(material, at(0, 0), at(1, a), at(1, step + 1), at(1, b));
    }
}

void check_no_holes(SceneMaker& maker, uint32_t triangles)
{
    const Scene scene = maker.make(constant_environment(1));
    const BuiltMesh surface = built_mesh(scene, {triangles, 0.2f, 0.7f});
    INFO(surface.loss.holes << " holes, the largest of " << surface.loss.largest_hole << " pixels");
    CHECK(surface.loss.holes == 0);
    CHECK(surface.mesh.patches.size() > triangles / 4);
}

}  // namespace

TEST_CASE("Surface meshes of rings have no holes", "[surface]")
{
    SceneMaker maker;
    add_ring(maker, maker.add(diffuse(grey(0.5f))), {0, 0, 0}, {0.7f, 0.25f}, {0, 1});
    check_no_holes(maker, 4000);
}

TEST_CASE("Surface meshes of thin handles have no holes", "[surface]")
{
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    maker.box(matter, {-0.5f, -0.5f, -0.6f}, {0.5f, 0.5f, 0.6f});
    add_ring(maker, matter, {0.5f, 0, 0}, {0.35f, 0.04f}, {-0.26f, 0.26f});
    add_ring(maker, matter, {-0.5f, 0, 0.2f}, {0.2f, 0.02f}, {0.24f, 0.76f});
    check_no_holes(maker, 4000);
}

TEST_CASE("Surface meshes of balls with an open mouth have no holes", "[surface]")
{
    constexpr float kOuter = 0.8f, kInner = 0.7f, kMouth = 0.7f;
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    add_open_ball(maker, matter, kOuter, kMouth, false);
    add_open_ball(maker, matter, kInner, kMouth, true);
    for (int step = 0; step < kRound; ++step) {
        const Vec3 a = direction_at(kMouth, static_cast<float>(step) / kRound);
        const Vec3 b = direction_at(kMouth, static_cast<float>((step + 1) % kRound) / kRound);
        maker.quad(matter, a * kOuter, b * kOuter, b * kInner, a * kInner);
    }
    maker.ball(matter, {0, 0, 0}, 0.3f, 24);
    check_no_holes(maker, 4000);
}

}  // namespace lumi::baker::testing
