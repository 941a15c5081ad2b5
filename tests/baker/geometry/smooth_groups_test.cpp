// SPDX-License-Identifier: MIT
#include "geometry/smooth_groups.h"

#include <catch2/catch.hpp>

#include "mesh/patch_mesh.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace lumi::baker::testing
{

TEST_CASE("Each face of a cube has vertices of its own, and their normals are its own", "[surface]")
{
    const Mesh mesh = with_creases(cube(0.5f), 0.7f);
    REQUIRE(mesh.positions.size() == 24);
    REQUIRE(mesh.normals.size() == 24);
    for (size_t k = 0; k < mesh.triangle_count(); ++k)
        for (const uint32_t corner : mesh.corners[k])
            CHECK(dot(mesh.normals[corner], normalized(mesh.area_vector(k))) == Approx(1));
}

TEST_CASE("Where nothing is a crease, vertices stay, and normals point along the diagonals", "[surface]")
{
    const Mesh mesh = with_creases(cube(0.5f), -0.1f);
    REQUIRE(mesh.positions.size() == 8);
    for (size_t v = 0; v < 8; ++v)
        CHECK(dot(mesh.normals[v], normalized(mesh.positions[v])) == Approx(1).epsilon(1e-5));
}

TEST_CASE("Right edges are creases of a surface field's mesh, facets of a coarse round body are not", "[surface]")
{
    const float crease_cosine = MeshSettings{}.crease_cosine;
    CHECK(with_creases(cube(0.5f), crease_cosine).positions.size() == 24);
    Mesh octahedron;  // its faces turn 71 degrees
    for (const float side : {-1.0f, 1.0f}) {
        octahedron.positions.push_back({side, 0, 0});
        octahedron.positions.push_back({0, side, 0});
        octahedron.positions.push_back({0, 0, side});
    }
    for (uint32_t k = 0; k < 8; ++k) {
        const uint32_t x = k & 1 ? 3 : 0, y = k & 2 ? 4 : 1, z = k & 4 ? 5 : 2;
        const bool is_mirrored = (((k >> 2) ^ (k >> 1) ^ k) & 1) == 0;
        octahedron.corners.push_back(is_mirrored ? Mesh::Corners{x, z, y} : Mesh::Corners{x, y, z});
    }
    CHECK(with_creases(octahedron, crease_cosine).positions.size() == 6);
}

TEST_CASE("Two sides of one sheet share no vertices", "[surface]")
{
    Mesh mesh = sheet(2, 2, 0.2f);
    const std::vector<Mesh::Corners> front = mesh.corners;
    for (const Mesh::Corners& c : front) mesh.corners.push_back({c[0], c[2], c[1]});
    const Mesh result = with_creases(mesh, 0.7f);
    REQUIRE(result.positions.size() == 18);
    for (size_t k = 0; k < result.triangle_count(); ++k)
        for (const uint32_t corner : result.corners[k])
            CHECK(result.normals[corner].z == Approx(k < front.size() ? 1 : -1));
}

TEST_CASE("Triangles share an edge like pages of a book, unless they are more than a surface can have", "[surface]")
{
    for (const uint32_t pages : {64u, 65u}) {
        Mesh book;
        book.positions = {{0, 0, 0}, {0, 0, 1}};
        for (uint32_t k = 0; k < pages; ++k) {
            const float angle = 0.01f * static_cast<float>(k);
            book.positions.push_back({std::cos(angle), std::sin(angle), 0});
            book.corners.push_back({0, 1, k + 2});
        }
        CHECK(with_creases(book, 0.7f).positions.size() == (pages == 64 ? pages + 2 : 3 * pages));
    }
}

TEST_CASE("A crease that ends inside a surface splits only the vertices that it parts", "[surface]")
{
    // Squares along x, of which the far half of the last one stands up.
    Mesh mesh = sheet(2, 2, 0.2f);
    mesh.positions[8].z = 0.6f;
    const Mesh result = with_creases(mesh, 0.7f);
    for (size_t k = 0; k < mesh.triangle_count(); ++k)
        for (size_t i = 0; i < 3; ++i) CHECK(length(result.position(k, i) - mesh.position(k, i)) == 0);
    CHECK(result.positions.size() == 11);  // the two ends of the crease, which reaches from rim to rim
}

}  // namespace lumi::baker::testing
