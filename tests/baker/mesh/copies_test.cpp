// SPDX-License-Identifier: MIT
#include "mesh/copies.h"

#include <catch2/catch.hpp>

#include "mesh/outside.h"
#include "support/shapes.h"
#include "support/surfaces.h"

namespace lumi::baker::testing
{
namespace
{

// A cloth with folds and a wavy hem, of kSquares² squares; each of them once more reversed if asked for.
enum class Backs { none, same_diagonals, other_diagonals };
Scene cloth(Backs backs)
{
    constexpr int kSquares = 40;
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    const auto at = [](int x, int y) {
        const float u = static_cast<float>(x) / kSquares, v = static_cast<float>(y) / kSquares;
        const float hem = 1 + 0.1f * std::sin(18 * u);
        return Vec3{1.2f * u - 0.6f, 0.08f * std::sin(20 * u), 0.6f - 1.1f * v * hem};
    };
    for (int y = 0; y < kSquares; ++y) {
        for (int x = 0; x < kSquares; ++x) {
            maker.quad(matter, at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
            if (backs == Backs::same_diagonals)
                maker.quad(matter, at(x, y), at(x, y + 1), at(x + 1, y + 1), at(x + 1, y));
            else if (backs == Backs::other_diagonals)
                maker.quad(matter, at(x, y + 1), at(x + 1, y + 1), at(x + 1, y), at(x, y));
        }
    }
    return maker.make(constant_environment(1));
}

size_t outside_triangles(const Scene& scene)
{
    const ProgressCallback silent;
    Job job(1, 2, silent);
    return outside_of(scene.data(), job).mesh.triangle_count();
}

}  // namespace

TEST_CASE("A triangle's first copy has its vertices in any order", "[mesh]")
{
    Mesh mesh;
    mesh.positions.resize(4);
    mesh.corners = {{0, 1, 2}, {0, 1, 3}, {2, 1, 0}, {1, 3, 0}, {1, 2, 3}, {1, 2, 0}};
    CHECK(first_copies(mesh) == std::vector<uint32_t>{0, 1, 0, 1, 4, 0});
}

TEST_CASE("The halves of a quad are copies of those of the same quad that is cut the other way", "[mesh]")
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1f}, {0, 1, 0}, {0.2f, 0.2f, 1}};
    mesh.corners = {{0, 1, 2}, {0, 2, 3}, {3, 1, 0}, {3, 2, 1}};
    CHECK(first_copies(mesh) == std::vector<uint32_t>{0, 1, 0, 1});
    mesh.corners = {{0, 1, 2}, {0, 2, 4}, {4, 1, 0}, {4, 2, 1}};  // a tetrahedron
    CHECK(first_copies(mesh) == std::vector<uint32_t>{0, 1, 2, 3});
}

TEST_CASE("Triangles around a vertex that has three of them are no copies of each other", "[mesh]")
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0.1f}, {1, 0, 0}, {-0.5f, 0.9f, 0}, {-0.5f, -0.9f, 0}};
    mesh.corners = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
    CHECK(first_copies(mesh) == std::vector<uint32_t>{0, 1, 2});
}

TEST_CASE("A cloth whose faces are written twice has the mesh of the cloth", "[mesh]")
{
    const BuiltMesh once = built_mesh(cloth(Backs::none), {500, 2, 0.2f});
    CHECK(once.loss.holes == 0);
    for (const Backs backs : {Backs::same_diagonals, Backs::other_diagonals}) {
        CHECK(outside_triangles(cloth(backs)) == outside_triangles(cloth(Backs::none)));
        const BuiltMesh twice = built_mesh(cloth(backs), {500, 2, 0.2f});
        CHECK(twice.loss.holes == 0);
        CHECK(twice.loss.missed < once.loss.missed + 0.002);
    }
}

TEST_CASE("The wall between two bodies that touch stays double", "[mesh]")
{
    const auto boxes = [](float gap) {
        SceneMaker maker;
        const uint32_t matter = maker.add(diffuse(grey(0.5f)));
        maker.box(matter, {-0.5f, -0.2f, -0.2f}, {0, 0.2f, 0.2f});
        maker.box(matter, {gap, -0.2f, -0.2f}, {0.5f, 0.2f, 0.2f});
        return maker.make(constant_environment(1));
    };
    CHECK(outside_triangles(boxes(0)) == outside_triangles(boxes(0.1f)));
}

}  // namespace lumi::baker::testing
