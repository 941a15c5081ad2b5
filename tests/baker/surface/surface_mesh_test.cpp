// SPDX-License-Identifier: MIT
#include "surface/surface_mesh.h"

#include <catch2/catch.hpp>

#include "lumi/surface_format.h"
#include "support/bake_scenes.h"
#include "support/silhouettes.h"
#include "support/surfaces.h"

namespace lumi::baker::testing
{
TEST_CASE("A surface mesh follows its scene and keeps what the format asks", "[surface]")
{
    const Scene scene = ball_over_floor(32, constant_environment(1));
    const BuiltSurface surface = built_surface(scene, {600, 0.2f, 0.7f});
    const SurfaceMesh& mesh = surface.mesh;
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
    for (const Vec3& n : mesh.normals) {
        CHECK(length(n) == Approx(1));
    }
    CHECK(missing_pixels(scene.data(), ProxyTracer(triangles, mesh.two_sided)).largest <= 2);
}

TEST_CASE("Meshes that would be too large for the format are made smaller", "[surface]")
{
    const Scene scene = ball_over_floor(48, constant_environment(1));
    for (const SurfaceMeshSettings& s : {SurfaceMeshSettings{20000, 2, 0.7f}, SurfaceMeshSettings{300, 0.05f, 0.7f}}) {
        const SurfaceMesh mesh = built_surface(scene, s).mesh;
        CHECK(mesh.positions.size() <= format::kMaxSurfaceVertices);
        CHECK(mesh.patches.size() <= format::kMaxPatches);
        CHECK(mesh.patches.size() > format::kMaxPatches / 2);
    }
}

}  // namespace lumi::baker::testing
