// SPDX-License-Identifier: MIT
// Shadows that move with their parts.
#include "shadow/part_shadows.h"

#include <catch2/catch.hpp>

#include "shadow/receiver.h"
#include "support/shapes.h"
#include "support/surfaces.h"
#include "surface/surface_scenes.h"

namespace lumi::baker::testing
{
namespace
{

constexpr float kHandGap = 0.1f, kDialSide = 0.6f, kHandHalf = 0.05f;

PartMovement hand()
{
    PartMovement movement;
    movement.name = "hand";
    movement.axis = {0, 0, 1};
    return movement;
}

// A thin bar of length 0.4 at kHandGap above a square dial, in the light that comes from `light`.
SceneMaker dial_with_hand(const PartMovement& movement, float dial_height = 0, const Vec3& light = {1, 0, 1})
{
    SceneMaker maker;
    const uint32_t white = maker.add(diffuse(grey(0.8f))), black = maker.add(diffuse(grey(0.02f)));
    maker.box(white, {-kDialSide, -kDialSide, dial_height - 0.2f}, {kDialSide, kDialSide, dial_height});
    maker.add(Fixture(DirectionalLight{normalized(light), grey(1)}));
    maker.begin_part(movement);
    maker.box(black, {-kHandHalf, -kHandHalf, kHandGap}, {0.4f, kHandHalf, kHandGap + 0.01f});
    return maker;
}

PartShadows shadows_of(const Scene& scene)
{
    MeshSettings settings;
    settings.triangles = 200;
    settings.longest_edge = 0.6f;
    SurfaceSettings surface = tiny_surface();
    surface.texels_per_radius = 60;
    return part_shadows(scene.data(), built_mesh(scene, settings).mesh, surface, {});
}

// At a place of the scene, in its rest.
uint8_t passed_at(const PartShadow& s, const Vec3& place)
{
    const Vec3 p = place - s.corner;
    const float u = dot(p, s.across) / dot(s.across, s.across), v = dot(p, s.down) / dot(s.down, s.down);
    if (u < 0 || u >= 1 || v < 0 || v >= 1) return 255;
    const auto x = static_cast<uint32_t>(u * static_cast<float>(s.columns)),
               y = static_cast<uint32_t>(v * static_cast<float>(s.rows));
    return s.passed[y * s.columns + x];
}

Scene lit_from_the_side()
{
    return dial_with_hand(hand()).make(constant_environment(0.02f));
}

// Traced once.
const PartShadow& side_shadow()
{
    static const PartShadows found = shadows_of(lit_from_the_side());
    REQUIRE(found.shadows.size() == 1);
    return found.shadows[0];
}

}  // namespace

TEST_CASE("part shadows: a shadow lies where the light throws it, and turns about an axis that is moved as far")
{
    const Scene scene = lit_from_the_side();
    const PartShadow& s = side_shadow();
    const float r = scene.radius();
    CHECK(s.pivot.x - scene.data().moving.motions[0].pivot.x == Approx(-kHandGap / r).margin(0.03));
    CHECK(s.pivot.y - scene.data().moving.motions[0].pivot.y == Approx(0).margin(0.03));
    const std::array<float, 3> c = scene.centre();
    const auto at = [&](float x, float y) { return passed_at(s, (Vec3{x, y, 0} - Vec3{c[0], c[1], c[2]}) / r); };
    for (const float along : {0.0f, 0.1f, 0.2f, 0.25f}) CHECK(at(along - kHandGap + 0.03f, 0) < 120);
    CHECK(at(0.15f, 0.15f) > 240);
    CHECK(at(-0.3f, 0) > 240);
}

TEST_CASE("part shadows: a shadow takes a share of the field's texels, and reads few beyond them")
{
    const PartShadow& s = side_shadow();
    CHECK(s.columns <= s.rows);
    CHECK(s.columns * s.rows <= most_shadow_texels(20'000));
    const auto inner_row = s.passed.begin() + s.columns;
    CHECK(std::any_of(inner_row, inner_row + s.columns, [](uint8_t passed) { return passed < 255; }));  // no clear rim
    const Scene scene = lit_from_the_side();
    MeshSettings settings;
    settings.triangles = 200;
    const PartShadows coarse = part_shadows(scene.data(), built_mesh(scene, settings).mesh, tiny_surface(), {});
    REQUIRE(coarse.shadows.size() == 1);
    CHECK(coarse.shadows[0].columns * coarse.shadows[0].rows <= kFewestShadowTexels);
}

TEST_CASE("part shadows: a shadow is found as far as a low light throws it, to either side")
{
    constexpr float kGaps = 1.75f;
    for (const float side : {-1.0f, 1.0f}) {
        const Scene scene = dial_with_hand(hand(), 0, {side * 0.5f, kGaps, 1}).make(constant_environment(0.02f));
        const PartShadows found = shadows_of(scene);
        REQUIRE(found.shadows.size() == 1);
        const Vec3 moved = found.shadows[0].pivot - scene.data().moving.motions[0].pivot;
        CHECK(moved.y == Approx(-kGaps * kHandGap / scene.radius()).margin(0.03));
    }
}

TEST_CASE("part shadows: a value between points of a grid is their mean, and half of it at the rim")
{
    ShadowGrid grid;
    grid.low = {-1, 2};
    grid.cell = {0.5f, 0.25f};
    grid.columns = 3;
    grid.rows = 2;
    const std::vector<float> values = {1, 2, 3, 4, 5, 6};
    for (uint32_t k = 0; k < grid.size(); ++k) CHECK(value_at(values, grid, grid.middle(k)) == Approx(values[k]));
    CHECK(value_at(values, grid, {-0.5f, 2.25f}) == Approx(3));
    CHECK(value_at(values, grid, {-1, 2.125f}) == Approx(0.5));
    CHECK(value_at(values, grid, {0.5f, 2.125f}) == Approx(1.5));
    CHECK(value_at(values, grid, {-0.75f, 2}) == Approx(0.5));
    CHECK(value_at(values, grid, {-0.75f, 2.5f}) == Approx(2));
    CHECK(value_at(values, grid, {-2, 2.125f}) == 0);
}

TEST_CASE("part shadows: a bright sky passes where the lamp does not")
{
    const Scene scene = dial_with_hand(hand()).make(constant_environment(0.3f));
    const PartShadows found = shadows_of(scene);
    REQUIRE(found.shadows.size() == 1);
    const std::array<float, 3> c = scene.centre();
    const Vec3 place = (Vec3{0.13f - kHandGap, 0, 0} - Vec3{c[0], c[1], c[2]}) / scene.radius();
    // The lamp gives 0.71 of light, the sky 0.94, of which the bar hides some: two fifths pass, 0.7 as a display has
    // it.
    const int passed = passed_at(found.shadows[0], place);
    CHECK(passed > 150);
    CHECK(passed < 200);
}

TEST_CASE("part shadows: a border lets all light pass, so that no edge shows")
{
    const PartShadow& s = side_shadow();
    for (uint32_t x = 0; x < s.columns; ++x) CHECK(s.passed[x] == 255);
    for (uint32_t y = 0; y < s.rows; ++y) CHECK(s.passed[y * s.columns + s.columns - 1] == 255);
}

TEST_CASE("part shadows: a part without a flat receiver has none, and says why")
{
    PartMovement across = hand();
    across.axis = {0, 1, 0};
    const auto none = [](const Scene& scene, const std::string& word) {
        const PartShadows found = shadows_of(scene);
        CHECK(found.shadows.empty());
        REQUIRE(found.notes.size() == 1);
        CHECK_THAT(found.notes[0], Catch::Contains("'hand' casts no shadow") && Catch::Contains(word));
    };
    none(dial_with_hand(across).make(constant_environment(1)), "nothing flat");
    none(dial_with_hand(hand(), -0.5f).make(constant_environment(1)), "nothing flat");
    PartMovement slide = hand();
    slide.slides = true;
    slide.is_limited = true;
    slide.to = 0.1;
    none(dial_with_hand(slide).make(constant_environment(1)), "slides");
}

}  // namespace lumi::baker::testing
