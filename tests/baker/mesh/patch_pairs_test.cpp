// SPDX-License-Identifier: MIT
#include "mesh/patch_pairs.h"

#include <catch2/catch.hpp>
#include <set>

#include "geometry/smooth_groups.h"
#include "math/sampler.h"
#include "mesh/edge_split.h"
#include "support/mesh_checks.h"

namespace lumi::baker::testing
{
namespace
{

using Patch = PatchMesh::Patch;

// From its lowest vertex on.
Mesh::Corners turned(Mesh::Corners c)
{
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    return c;
}

// Whether patches hold each triangle of the mesh once, wound as it is there.
bool holds_all(const std::vector<Patch>& patches, const Mesh& mesh)
{
    std::multiset<Mesh::Corners> in_mesh, in_patches;
    for (const Mesh::Corners& c : mesh.corners) in_mesh.insert(turned(c));
    for (const Patch& p : patches) {
        in_patches.insert(turned({p.a, p.b, p.c}));
        if (p.d != PatchMesh::kNone) in_patches.insert(turned({p.d, p.c, p.b}));
    }
    return in_mesh == in_patches;
}

size_t lone(const std::vector<Patch>& patches)
{
    return static_cast<size_t>(std::count_if(
        patches.begin(), patches.end(), [](const Patch& p) { return p.d == PatchMesh::kNone; }));
}

// A sheet whose vertices are moved and whose diagonals are flipped at random.
Mesh crumpled_sheet(uint32_t size)
{
    Mesh mesh = sheet(size, size, 0.1f);
    Sampler sampler(3, 0, 0);
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
        sampler.start(static_cast<uint32_t>(v));
        const Vec2 by = sampler.next_2d();
        mesh.positions[v] = mesh.positions[v] + Vec3{by.x - 0.5f, by.y - 0.5f, 0} * 0.06f;
    }
    for (size_t k = 0; k < mesh.triangle_count(); k += 2) {
        sampler.start(static_cast<uint32_t>(k));
        const auto [a, b, c] = mesh.corners[k];
        const uint32_t d = mesh.corners[k + 1][0];
        if (sampler.next_2d().x < 0.5f) {
            mesh.corners[k] = {a, b, d};
            mesh.corners[k + 1] = {a, d, c};
        }
    }
    return mesh;
}

}  // namespace

TEST_CASE("Squares become patches, each with its corners in order", "[surface]")
{
    const Mesh mesh = sheet(5, 4, 0.1f);
    const std::vector<Patch> patches = paired(mesh);
    REQUIRE(holds_all(patches, mesh));
    CHECK(patches.size() == 20);
    for (const Patch& p : patches) {
        const Vec3 gap = mesh.positions[p.a] + mesh.positions[p.d] - mesh.positions[p.b] - mesh.positions[p.c];
        CHECK(length(gap) < 1e-6f);
        CHECK(length(mesh.positions[p.b] - mesh.positions[p.c]) == Approx(0.1414).epsilon(0.01));
    }
}

TEST_CASE("Few triangles of a crumpled sheet stay alone", "[surface]")
{
    const Mesh mesh = crumpled_sheet(40);
    const std::vector<Patch> patches = paired(mesh);
    CHECK(holds_all(patches, mesh));
    CHECK(lone(patches) <= mesh.triangle_count() / 100);
}

TEST_CASE("Pairs do not cross creases", "[surface]")
{
    const Mesh mesh = with_creases(cube(0.5f), 0.7f);
    const std::vector<Patch> patches = paired(mesh);
    CHECK(holds_all(patches, mesh));
    CHECK(patches.size() == 6);
}

TEST_CASE("A lone triangle's first corner is opposite its longest edge", "[surface]")
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0.5f, 0, 0}, {0.5f, 0.3f, 0}};
    mesh.corners = {{0, 1, 2}};
    const std::vector<Patch> patches = paired(mesh);
    REQUIRE(patches.size() == 1);
    CHECK(patches[0].a == 1);
    CHECK(patches[0].b == 2);
    CHECK(patches[0].c == 0);
    CHECK(patches[0].d == PatchMesh::kNone);
}

TEST_CASE("Triangles wound against each other are no pair, nor are the two sides of one", "[surface]")
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0}, {0.5f, 0.5f, 0}};
    mesh.corners = {{0, 1, 2}, {1, 2, 3}};
    CHECK(paired(mesh).size() == 2);
    mesh.corners = {{0, 1, 2}, {0, 2, 1}};
    CHECK(paired(mesh).size() == 2);
    CHECK(holds_all(paired(mesh), mesh));
}

}  // namespace lumi::baker::testing
