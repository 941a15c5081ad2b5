// SPDX-License-Identifier: MIT
#include "mesh/rounded_mesh.h"

#include <catch2/catch.hpp>

#include "math/sampler.h"
#include "support/mesh_checks.h"

namespace lumi::baker::testing
{

TEST_CASE("Rounded vertices are whole steps within the sphere and near where they were", "[surface]")
{
    constexpr uint32_t kTriangles = 1000;
    constexpr float kStep = 1.0f / (1 << 14);
    Mesh mesh;
    Sampler sampler(7, 0, 0);
    for (uint32_t k = 0; k < 3 * kTriangles; ++k) {
        sampler.start(k);
        const Vec2 place = sampler.next_2d();
        mesh.positions.push_back(direction_at(2 * place.x - 1, place.y));  // on the sphere: the hardest place
    }
    for (uint32_t k = 0; k < kTriangles; ++k) mesh.corners.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    const Mesh result = rounded(mesh);
    REQUIRE(result.triangle_count() == kTriangles);
    for (size_t k = 0; k < kTriangles; ++k) {
        for (size_t i = 0; i < 3; ++i) {
            const Vec3& p = result.position(k, i);
            for (const float c : {p.x, p.y, p.z}) CHECK(c / kStep == std::round(c / kStep));
            CHECK(dot(p, p) <= 1);
            CHECK(length(p - mesh.position(k, i)) < 2 * kStep);
        }
    }
}

TEST_CASE("What rounding leaves without area goes, and vertices meet", "[surface]")
{
    Mesh mesh = sheet(2, 1, 0.25f);
    mesh.positions.push_back({0.25f, 1e-5f, 0});   // falls onto vertex 1
    mesh.positions.push_back({0.125f, 1e-5f, 0});  // falls between vertices 0 and 1
    mesh.positions.push_back({0.5f, 0.5f, 0});     // in no triangle
    mesh.corners.push_back({0, 6, 1});
    mesh.corners.push_back({0, 1, 7});
    mesh.corners[2][0] = 6;
    const Mesh result = rounded(mesh);
    CHECK(result.triangle_count() == 4);
    CHECK(result.positions.size() == 6);
    CHECK(whole_area(result) == Approx(0.125));
}

}  // namespace lumi::baker::testing
