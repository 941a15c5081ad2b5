// SPDX-License-Identifier: MIT
#include "mesh/patch_mesh.h"

#include <catch2/catch.hpp>

#include "lumi/surface/format.h"
#include "math/warp.h"
#include "mesh/mesh_loss.h"
#include "support/bake_scenes.h"
#include "support/surfaces.h"

namespace lumi::baker::testing
{
TEST_CASE("A surface mesh follows its scene and keeps what the format asks", "[surface]")
{
    const Scene scene = ball_over_floor(32, constant_environment(1));
    const BuiltMesh surface = built_mesh(scene, {600, 0.2f, 0.7f});
    const PatchMesh& mesh = surface.mesh;
    CHECK(mesh.longest_edge <= 0.2f * 1.001f);
    CHECK(mesh.longest_edge > 0.1f);
    CHECK(surface.loss.missed < 0.005);
    CHECK(surface.loss.displaced < 0.005);
    REQUIRE(mesh.normals.size() == mesh.positions.size());
    std::vector<bool> used(mesh.positions.size(), false);
    const Mesh triangles = triangles_of(mesh);
    for (size_t k = 0; k < triangles.triangle_count(); ++k) {
        CHECK(triangles.area(k) > 0);
        for (const uint32_t corner : triangles.corners[k]) {
            used[corner] = true;
            CHECK(dot(mesh.normals[corner], normalized(triangles.area_vector(k))) > 0.4f);
        }
    }
    CHECK(std::count(used.begin(), used.end(), false) == 0);
    for (const Vec3& n : mesh.normals) CHECK(length(n) == Approx(1));
    CHECK(surface.loss.holes == 0);
}

TEST_CASE("Meshes that would be too large for the format are made smaller", "[surface][statistics]")
{
    const PatchMesh mesh = built_mesh(ball_over_floor(24, constant_environment(1)), {300, 0.05f, 0.7f}).mesh;
    CHECK(mesh.positions.size() <= detail::format::kMaxSurfaceVertices);
    CHECK(mesh.patches.size() <= detail::format::kMaxPatches);
    CHECK(mesh.patches.size() > detail::format::kMaxPatches / 2);
}

TEST_CASE("Hidden triangles take nothing from those that can be seen", "[surface][statistics]")
{
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    maker.ball(matter, {0, 0, 0}, 0.8f, 40);
    maker.ball(matter, {0, 0, 0}, 0.6f, 40);
    maker.quad(matter, {0, 0, 0.8f}, {0.05f, 0, 0.7f}, {0, 0, 0.6f}, {-0.05f, 0, 0.7f});  // joins them
    const size_t triangles =
        triangles_of(built_mesh(maker.make(constant_environment(1)), {1000, 2, 0.7f}).mesh).triangle_count();
    CHECK(triangles > 900);
    CHECK(triangles < 1100);
}

TEST_CASE("Leaves that are cut out of larger faces have a mesh", "[surface]")
{
    SceneMaker maker;
    Material leaf = diffuse({0.1f, 0.5f, 0.1f});
    leaf.opacity = 0.4f;
    leaf.finish();
    const uint32_t leaves = maker.add(leaf);
    for (const float x : {-0.4f, 0.0f, 0.4f})
        maker.quad(leaves, {x, -0.5f, -0.5f}, {x + 0.3f, -0.5f, 0.4f}, {x + 0.3f, 0.5f, 0.4f}, {x, 0.5f, -0.5f});
    maker.ball(maker.add(diffuse(grey(0.5f))), {0, 0, 0.6f}, 0.2f, 12);
    const BuiltMesh surface = built_mesh(maker.make(constant_environment(1)), {500, 0.2f, 0.7f});
    CHECK(surface.mesh.patches.size() > 100);
    CHECK(surface.loss.holes == 0);
}

TEST_CASE("Leaky meshes come with a warning each", "[surface]")
{
    CHECK(mesh_warnings({}, {1000, 1000}, false).empty());
    MeshLoss loss;
    loss.missed = 0.0123;
    const std::vector<MeshWarning> of_surface = mesh_warnings(loss, {1000, 1000}, false);
    CHECK_THAT(of_surface.at(0).problem, Catch::Contains("misses 1.2 %"));
    CHECK_THAT(of_surface.at(0).remedy, Catch::Contains("thicken"));
    CHECK(of_surface.at(0).more_triangles_help);
    CHECK_FALSE(mesh_warnings(loss, {1000, 1000, true}, false).at(0).more_triangles_help);
    const std::vector<MeshWarning> of_volume = mesh_warnings(loss, {1000, 1000}, true);
    CHECK_THAT(of_volume.at(0).problem, Catch::Contains("misses 1.2 %"));
    CHECK_THAT(of_volume.at(0).remedy, Catch::Contains("chord"));
    CHECK_FALSE(of_volume.at(0).more_triangles_help);
    loss.holes = 3;
    CHECK(mesh_warnings(loss, {1000, 1000}, false).size() == 2);
    CHECK_THAT(mesh_warnings(loss, {1000, 300}, false).at(1).problem, Catch::Contains("300 triangles where 1000"));
}

TEST_CASE("Wires thinner than half a pixel are named, and thicker ones are not", "[surface]")
{
    const auto thin_share = [](float thick) {
        SceneMaker maker;
        const uint32_t matter = maker.add(diffuse(grey(0.5f)));
        for (int k = 0; k < 8; ++k) {
            const float low = 0.15f * static_cast<float>(k) - 0.6f;
            maker.box(matter, {low, -0.7f, 0}, {low + thick, 0.7f, thick});
        }
        maker.ball(matter, {0, 0, 0.4f}, 0.3f);
        maker.span_unit_sphere();
        const BuiltMesh surface = built_mesh(maker.make(constant_environment(1)), {500, 0.5f, 0.2f});
        const bool is_named = std::any_of(surface.warnings.begin(), surface.warnings.end(), [](const MeshWarning& w) {
            return w.problem.find("thinner than a pixel") != std::string::npos;
        });
        CHECK(is_named == (surface.loss.thin > 0.001));
        return surface.loss.thin;
    };
    CHECK(thin_share(0.003f) > 0.05);
    CHECK(thin_share(0.012f) < 0.001);
}

TEST_CASE("A mesh of far too few triangles does not come silently", "[surface]")
{
    SceneMaker maker;  // bricks: most edges have more than two triangles
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    for (int k = 0; k < 216; ++k) {
        const Vec3 p =
            Vec3{static_cast<float>(k % 6), static_cast<float>(k / 6 % 6), static_cast<float>(k / 36)} * 0.15f;
        maker.box(matter, p, p + Vec3{0.15f, 0.15f, 0.15f});
    }
    const BuiltMesh surface = built_mesh(maker.make(constant_environment(1)), {60, 2, 0.7f});
    CHECK_FALSE(surface.warnings.empty());
}

}  // namespace lumi::baker::testing
