// SPDX-License-Identifier: MIT
#include "mesh/mesh_draft.h"

#include <catch2/catch.hpp>

#include "support/shapes.h"
#include "support/surfaces.h"

namespace lumi::baker::testing
{

TEST_CASE("Bars whose edges are split do not grow onto the bar beside them", "[mesh]")
{
    constexpr float kLength = 1.8f, kThick = 0.06f, kGap = 0.06f;
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    for (int k = 0; k < 3; ++k) {
        const float low = (kThick + kGap) * static_cast<float>(k - 1);
        maker.box(matter, {-kLength / 2, low, 0}, {kLength / 2, low + kThick, kThick});
    }
    const BuiltMesh bars = built_mesh(maker.make(constant_environment(1)), {36, 0.3f, 0.2f});
    CHECK(bars.mesh.patches.size() > 36);
    CHECK(bars.loss.added < 0.001);
    CHECK(bars.loss.displaced < 0.001);
}

TEST_CASE("A mesh that need not be simplified is not moved either", "[mesh]")
{
    constexpr float kStep = 1.0f / (1 << 14);  // of a field's places
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    for (int k = 0; k < 8; ++k) {  // wires, half a pixel thick
        const float low = 0.15f * static_cast<float>(k) - 0.6f;
        maker.box(matter, {low, -0.7f, 0.02f * low}, {low + 0.004f, 0.7f, 0.02f * low + 0.004f});
    }
    const Scene scene = maker.make(constant_environment(1));
    const Mesh drawn = triangles_of(built_mesh(scene, {200, 0.5f, 0.2f}).mesh);
    for (const Vec3& corner : welded(scene.data().mesh).positions) {
        float nearest = 1;
        for (const Vec3& p : drawn.positions) nearest = std::min(nearest, length(p - corner));
        CHECK(nearest <= kStep);
    }
}

}  // namespace lumi::baker::testing
