// SPDX-License-Identifier: MIT
#include "pack/surface_writer.h"

#include <catch2/catch.hpp>
#include <string>

#include "lumi/surface/field.h"

using namespace lumi;
using namespace lumi::baker;

namespace
{

// A square at a height, of four vertices of its own.
void add_square(PatchMesh& mesh, float half, float z)
{
    const auto a = static_cast<uint32_t>(mesh.positions.size());
    for (const float y : {-half, half}) {
        for (const float x : {-half, half}) {
            mesh.positions.push_back({x, y, z});
            mesh.normals.push_back({0, 0, 1});
        }
    }
    mesh.patches.push_back({a, a + 1, a + 2, a + 3});
}

}  // namespace

TEST_CASE("vertices and patches of moving parts lie together in the file, which opens")
{
    constexpr float kThird = 1.0f / 3;
    PatchMesh mesh;
    mesh.longest_edge = 1;
    for (const float z : {-0.5f, 0.0f, 0.25f, 0.25f, 0.5f}) add_square(mesh, 0.5f, z);
    std::swap(mesh.patches[0].a, mesh.patches[1].a);  // numbers of the body's two patches are mixed
    mesh.see_through_patches = 1;
    mesh.parts = {{"knob \u00D8", false, true, {0, 0, 1}, {0.25f, -0.5f, 0}, -0.25, 0.5, 2},
                  {"slider", true, false, {kThird, -2 * kThird, 2 * kThird}, {}, -0.125, 0.25, 3}};
    const FitShape shape(mesh, std::vector<float>(mesh.patches.size(), 4));
    FieldParts parts{};
    parts.radius = 1;
    parts.texels.resize(shape.layout.texels);
    parts.views.resize(mesh.positions.size());
    for (size_t v = 0; v < 16; v += 3) parts.views[v].gains = {1, 2, 3};
    const std::vector<uint8_t> file = surface_file(shape, parts);
    SurfaceField field;
    REQUIRE(open_surface<SurfaceFeatures::all>(file.data(), file.size(), field) == FieldError::none);
    CHECK(field.patch_count == 4);
    CHECK(field.viewed_count == 6);
    REQUIRE(mover_count(field) == 2);
    const PartName name = part_name(field, 0);
    CHECK(std::string(name.text, name.bytes) == mesh.parts[0].name);
    const PartMotion turn = part_motion(field, 0), slide = part_motion(field, 1);
    CHECK(!turn.slides);
    CHECK(turn.light_stays);
    CHECK(turn.pivot.x == kOneQ20 / 4);
    CHECK(turn.pivot.y == -kOneQ20 / 2);
    CHECK(turn.from == -(1 << 30));
    CHECK(turn.span == 3u << 30);
    CHECK(slide.slides);
    CHECK(!slide.light_stays);
    CHECK(slide.from == -kOneQ20 / 8);
    CHECK(slide.span == 3 * kOneQ20 / 8);
    for (uint32_t p = 0; p < 5; ++p) {
        const detail::SurfacePatch patch = detail::surface_patch(field, p);
        for (uint32_t corner = 0; corner < 4; ++corner)
            CHECK(detail::surface_vertex(field, patch.corner[corner]).z ==
                  std::lround(mesh.positions[shape.vertex(p, corner)].z * 16384));
    }
}

TEST_CASE("a part that spans a turn is free")
{
    PatchMesh mesh;
    mesh.longest_edge = 1;
    add_square(mesh, 0.5f, 0);
    mesh.parts = {{"wheel", false, false, {0, 0, 1}, {}, -3, 4, 0}};
    const FitShape shape(mesh, {4});
    FieldParts parts{};
    parts.radius = 1;
    parts.texels.resize(shape.layout.texels);
    parts.views.resize(4);
    const std::vector<uint8_t> file = surface_file(shape, parts);
    SurfaceField field;
    REQUIRE(open_surface<SurfaceFeatures::all>(file.data(), file.size(), field) == FieldError::none);
    CHECK(part_motion(field, 0).span == UINT32_MAX);
}
