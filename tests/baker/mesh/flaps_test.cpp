// SPDX-License-Identifier: MIT
#include "mesh/simplify/steps.h"

#include <catch2/catch.hpp>

namespace lumi::baker::testing
{
namespace
{

constexpr uint32_t kSheetSquares = 20;

uint32_t grid_vertex(uint32_t x, uint32_t y)
{
    return (kSheetSquares + 1) * y + x;
}

// A sheet of kSheetSquares times kSheetSquares squares of area 1, all of it surface 0. Further triangles are surfaces
// of their own.
struct FlappedSheet {
    FlappedSheet()
    {
        for (uint32_t y = 0; y <= kSheetSquares; ++y)
            for (uint32_t x = 0; x <= kSheetSquares; ++x)
                mesh.positions.push_back({static_cast<float>(x), static_cast<float>(y), 0});
        for (uint32_t y = 0; y < kSheetSquares; ++y) {
            for (uint32_t x = 0; x < kSheetSquares; ++x) {
                add(0, {grid_vertex(x, y), grid_vertex(x + 1, y), grid_vertex(x + 1, y + 1)});
                add(0, {grid_vertex(x, y), grid_vertex(x + 1, y + 1), grid_vertex(x, y + 1)});
            }
        }
    }

    void add(uint32_t surface, const Mesh::Corners& triangle)
    {
        mesh.corners.push_back(triangle);
        surfaces.push_back(surface);
    }

    uint32_t vertex(const Vec3& p)
    {
        mesh.positions.push_back(p);
        return static_cast<uint32_t>(mesh.positions.size() - 1);
    }

    size_t left_out(double small) const { return mesh.triangle_count() - without_flaps(mesh, surfaces, small).size(); }

    Mesh mesh;
    std::vector<uint32_t> surfaces;  // by triangle
};

}  // namespace

TEST_CASE("A small fin is left out, and a large one stays", "[mesh]")
{
    FlappedSheet sheet;
    sheet.add(1, {grid_vertex(5, 5), grid_vertex(6, 5), sheet.vertex({5.5f, 5, 0.2f})});  // area 0.1
    CHECK(sheet.left_out(0.2) == 1);
    CHECK(sheet.left_out(0.05) == 0);
    const std::vector<Mesh::Corners> kept = without_flaps(sheet.mesh, sheet.surfaces, 0.2);
    sheet.mesh.corners.pop_back();
    CHECK(kept == sheet.mesh.corners);
}

TEST_CASE("Of a small roof and the floor below it one stays, so that no hole is left", "[mesh]")
{
    FlappedSheet sheet;
    constexpr uint32_t kFloor = 2 * (5 * kSheetSquares + 5), kAt = 5;
    sheet.surfaces[kFloor] = 1;  // area 0.5
    const uint32_t top = sheet.vertex({5.7f, 5.3f, 0.1f});
    sheet.add(2, {grid_vertex(kAt, kAt), grid_vertex(kAt + 1, kAt), top});
    sheet.add(2, {grid_vertex(kAt + 1, kAt), grid_vertex(kAt + 1, kAt + 1), top});
    sheet.add(2, {grid_vertex(kAt + 1, kAt + 1), grid_vertex(kAt, kAt), top});
    CHECK(sheet.left_out(1) == 1);  // the floor, which is smaller
    sheet.surfaces[kFloor] = 0;
    CHECK(sheet.left_out(1) == 3);
}

TEST_CASE("What hangs at nothing stays, and no body loses much", "[mesh]")
{
    FlappedSheet leaf;
    leaf.add(1, {leaf.vertex({0, 0, 1}), leaf.vertex({0.1f, 0, 1}), leaf.vertex({0, 0.1f, 1})});
    CHECK(leaf.left_out(1) == 0);
    FlappedSheet rows;  // 90 fins of area 0.125 on 400 of area
    for (uint32_t k = 0; k < 90; ++k) {
        const uint32_t x = k % 10, y = 1 + k / 10;
        const float left = static_cast<float>(x), depth = static_cast<float>(y);
        rows.add(1 + k, {grid_vertex(x, y), grid_vertex(x + 1, y), rows.vertex({left, depth, 0.25f})});
    }
    CHECK(rows.left_out(1) == 65);  // a fiftieth of 411.25
}

}  // namespace lumi::baker::testing
