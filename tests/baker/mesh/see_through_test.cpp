// SPDX-License-Identifier: MIT
#include "mesh/see_through.h"

#include <catch2/catch.hpp>
#include <numeric>

#include "geometry/drawing_order.h"
#include "lumi/surface/format.h"
#include "support/shapes.h"

namespace lumi::baker::testing
{
namespace
{

constexpr float kOuter = 0.55f, kInner = 0.25f;

// Tiles with gaps between them, four on each side of a cube.
void add_tiles(SceneMaker& maker, uint32_t material, float reach)
{
    const auto at = [&](size_t axis, float side, float u, float v) {
        float p[3];
        p[axis] = side * reach;
        p[(axis + 1) % 3] = u * reach;
        p[(axis + 2) % 3] = v * reach;
        return Vec3{p[0], p[1], p[2]};
    };
    constexpr float kGap = 0.02f;
    for (size_t axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            for (const float u : {kGap - 1, kGap}) {
                for (const float v : {kGap - 1, kGap}) {
                    const float u1 = u + 1 - 2 * kGap, v1 = v + 1 - 2 * kGap;
                    maker.quad(material, at(axis, side, u, v), at(axis, side, u1, v), at(axis, side, u1, v1),
                               at(axis, side, u, v1));
                }
            }
        }
    }
}

Scene tiles_in_tiles()
{
    SceneMaker maker;
    Material tile = lamp(grey(0.5f));
    tile.opacity = 0.95f;
    tile.finish();
    const uint32_t material = maker.add(tile);
    add_tiles(maker, material, kInner);
    add_tiles(maker, material, kOuter);
    maker.span_unit_sphere();
    return maker.make(constant_environment(0));
}

// Edges are not split unless `longest_edge` says so.
BuiltMesh built_of(uint32_t cards, float longest_edge = 2, size_t patches = detail::format::kMaxPatches)
{
    const Scene scene = tiles_in_tiles();
    const std::unique_ptr<SceneData> opaque = opaque_part(scene.data());
    REQUIRE(opaque);
    BuiltMesh built;
    Job job(1, 1, {});
    MeshSettings settings;
    settings.longest_edge = longest_edge;
    add_see_through(scene.data(), *opaque, settings, {4, cards, patches}, built, job);
    return built;
}

struct Corners {
    size_t outer = 0, inner = 0;
};

Corners corners_of(const PatchMesh& mesh)
{
    Corners count;
    for (const Vec3& p : mesh.positions) {
        const float reach = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        ++(reach > (kInner + kOuter) / 2 ? count.outer : count.inner);
    }
    return count;
}

}  // namespace

TEST_CASE("Of a cloud of cards those stay that are seen most", "[mesh]")
{
    const BuiltMesh built = built_of(56);  // the outer 48 triangles, and 8 of the inner ones
    const Corners corners = corners_of(built.mesh);
    CHECK(corners.outer == 4 * 24);
    CHECK(corners.inner == 4 * 4);
    REQUIRE(built.warnings.size() == 1);
    CHECK(built.warnings[0].problem ==
          "of 96 see-through triangles, such as leaves, the 56 that are seen most are drawn");
    CHECK(built.warnings[0].more_triangles_help);
    CHECK(built.loss.missed_see_through < 0.1);
    CHECK(built.loss.missed_see_through == built.loss.missed);
}

TEST_CASE("A cloud that has room is drawn whole, and a card's two sides share its corners", "[mesh]")
{
    const BuiltMesh built = built_of(96);
    CHECK(built.warnings.empty());
    CHECK(built.mesh.positions.size() == 4 * 48);
    CHECK(built.mesh.patches.size() == 2 * 48);
    CHECK(built.mesh.see_through_patches == 2 * 48);
    CHECK(built.loss.missed < 0.005);
    CHECK(viewable_vertices(built.mesh) == std::vector<uint8_t>(4 * 48, 0));
}

TEST_CASE("See-through patches stand in the order in which they are drawn", "[mesh]")
{
    const PatchMesh mesh = built_of(96).mesh;
    CHECK(mesh.is_in_drawing_order == 1);
    std::vector<uint32_t> patch_of;
    const Mesh triangles = see_through_triangles(mesh, patch_of);
    for (uint32_t& number : patch_of) number = number / 2 - mesh.opaque_patches();
    std::vector<uint32_t> as_they_stand(mesh.see_through_patches);
    std::iota(as_they_stand.begin(), as_they_stand.end(), 0u);
    Job job(1, 1, {});
    CHECK(order_faults({triangles, patch_of}, as_they_stand, job).in_order == 0);
}

TEST_CASE("What splits long edges of a round see-through body lies on it", "[mesh]")
{
    constexpr float kRadius = 0.7f;
    SceneMaker maker;
    Material glass = lamp(grey(0.5f));
    glass.opacity = 0.4f;
    glass.finish();
    maker.ball(maker.add(glass), {0, 0, 0}, kRadius, 32);
    maker.span_unit_sphere();
    const Scene scene = maker.make(constant_environment(0));
    BuiltMesh built;
    Job job(1, 1, {});
    MeshSettings settings;
    add_see_through(scene.data(), *opaque_part(scene.data()), settings, {200, 200, detail::format::kMaxPatches}, built,
                    job);
    CHECK(built.mesh.positions.size() > 150);
    for (const Vec3& p : built.mesh.positions) CHECK(length(p) > 0.98f * kRadius);
}

TEST_CASE("Edges of see-through parts are longer where there would be too many patches", "[mesh]")
{
    constexpr float kShort = 0.05f;
    constexpr size_t kWhole = 2 * 48;
    const BuiltMesh built = built_of(96, kShort, 500);
    CHECK(built.mesh.see_through_patches <= 500);
    CHECK(built.mesh.see_through_patches > kWhole);
    CHECK(built.warnings.empty());
    CHECK(built_of(96, kShort, 4).mesh.see_through_patches == kWhole);
}

TEST_CASE("An opaque part that touches its sphere but for rounding is a scene", "[mesh]")
{
    SceneMaker maker;
    const Vec3 top = {2.0f / 3, 2.0f / 3, 1.0f / 3};  // of binary32, so a little outside
    Material glass = lamp(grey(0.5f));
    glass.opacity = 0.4f;
    glass.finish();
    maker.quad(maker.add(lamp(grey(0.5f))), {0, 0, 0}, {0.5f, 0, 0}, top, {0, 0.5f, 0});
    maker.quad(maker.add(glass), {0, 0, 0}, {0, 0, -0.5f}, {0, 0.5f, -0.5f}, {0, 0.5f, 0});
    maker.span_unit_sphere();
    CHECK(opaque_part(maker.make(constant_environment(0)).data()));
}

TEST_CASE("Cards that are left out count as missed", "[mesh]")
{
    const BuiltMesh built = built_of(24);
    CHECK(corners_of(built.mesh).outer == 4 * 12);
    CHECK(built.loss.missed > 0.15);
}

}  // namespace lumi::baker::testing
