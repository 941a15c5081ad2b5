// SPDX-License-Identifier: MIT
#include "mesh/edge_split.h"

#include <catch2/catch.hpp>

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

}  // namespace lumi::baker::testing
