// SPDX-License-Identifier: MIT
#include "mesh/edge_split.h"

#include <catch2/catch.hpp>

#include "math/sampler.h"
#include "support/mesh_checks.h"

namespace lumi::baker::testing
{
namespace
{

Vec3 stay(const Vec3& middle, const Vec3&, float)
{
    return middle;
}

}  // namespace

TEST_CASE("Long edges are split, and closed meshes stay closed", "[surface]")
{
    for (const float longest : {0.9f, 0.3f, 0.11f}) {
        const Mesh mesh = with_short_edges(cube(0.5f), longest, stay);
        CHECK(longest_edge(mesh) <= longest);
        CHECK(open_edges(mesh) == 0);
        CHECK(whole_area(mesh) == Approx(6));
        // Triangles a quarter as large as edges allow are enough.
        CHECK(static_cast<double>(mesh.triangle_count()) < 6 / (0.25 * 0.43 * static_cast<double>(longest * longest)));
    }
}

TEST_CASE("Short edges stay", "[surface]")
{
    CHECK(with_short_edges(sheet(3, 4, 0.1f), 0.2f, stay).corners == sheet(3, 4, 0.1f).corners);
}

TEST_CASE("New vertices go where they are placed, but rims stay straight", "[surface]")
{
    const PlaceMiddle lift = [](const Vec3& middle, const Vec3& facing, float length) {
        CHECK(facing.z == Approx(1).margin(0.3));
        return middle + facing * (0.05f * length);
    };
    const Mesh mesh = with_short_edges(sheet(1, 1, 1), 0.8f, lift);
    CHECK(mesh.positions.size() > 5);
    for (const Vec3& p : mesh.positions) {
        const bool inside = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1;
        CHECK((p.z > 0) == inside);
    }
}

TEST_CASE("Edges of three triangles are split in all of them", "[surface]")
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 0, 1}, {0.3f, 0, 0.5f}, {-0.3f, 0, 0.5f}, {0, 0.3f, 0.5f}};
    mesh.corners = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    mesh = with_short_edges(mesh, 0.7f, stay);
    CHECK(mesh.triangle_count() == 6);
    CHECK(mesh.positions.size() == 6);
}

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
