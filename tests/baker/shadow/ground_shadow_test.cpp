// SPDX-License-Identifier: MIT
// The shadow below an object on a ground that is not drawn.
#include "shadow/ground_shadow.h"

#include <catch2/catch.hpp>

#include "lumi/surface/field.h"
#include "support/shapes.h"
#include "support/surfaces.h"
#include "surface/surface_scenes.h"

namespace lumi::baker::testing
{
namespace
{

constexpr float kHalf = 0.3f, kHeight = 1;

// A black tower of this half width, from z = 0 up; its sphere is wide enough for its shadow.
Scene tower(float sky, const std::optional<Fixture>& lamp = std::nullopt)
{
    SceneMaker maker;
    maker.box(maker.add(diffuse(grey(0.01f))), {-kHalf, -kHalf, 0}, {kHalf, kHalf, kHeight});
    const uint32_t speck = maker.add(diffuse(grey(0.5f)));
    for (const float side : {-1.0f, 1.0f})
        maker.box(speck, {side - 0.001f, -0.001f, 0.5f}, {side + 0.001f, 0.001f, 0.502f});
    if (lamp) maker.add(*lamp);
    return maker.make(constant_environment(sky));
}

SurfaceSettings with_ground()
{
    SurfaceSettings settings = tiny_surface();
    settings.texels_per_radius = 40;
    settings.ground = true;
    return settings;
}

GroundShadow shadow_of(const Scene& scene)
{
    MeshSettings settings;
    settings.triangles = 200;
    settings.longest_edge = 0.6f;
    return ground_shadow(scene.data(), built_mesh(scene, settings).mesh, with_ground(), {});
}

// At a place of the scene: the share that the nearest texel lets pass.
uint8_t passed_at(const GroundShadow& s, const Scene& scene, const Vec2& place)
{
    const std::array<float, 3> c = scene.centre();
    const Vec3 wanted = {(place.x - c[0]) / scene.radius(), (place.y - c[1]) / scene.radius(), s.height};
    float nearest = 10;
    uint8_t passed = 0;
    for (uint32_t y = 0; y < s.pieces * s.side; ++y) {
        for (uint32_t x = 0; x < s.pieces * s.side; ++x) {
            const float distance = length(s.place(x, y) - wanted);
            if (distance >= nearest) continue;
            nearest = distance;
            passed = s.passed[s.texel(x, y)];
        }
    }
    return passed;
}

}  // namespace

TEST_CASE("ground shadow: it is darkest below the rim, fades away from it, and is nothing where the sphere ends")
{
    const Scene scene = tower(1);
    const GroundShadow s = shadow_of(scene);
    REQUIRE(s.is_there());
    CHECK(s.notes.empty());
    CHECK(s.height == Approx((0 - scene.centre()[2]) / scene.radius()).margin(1e-4));
    CHECK(s.height * s.height + s.radius * s.radius < 1);
    for (const Vec2 direction : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
        const auto at = [&](float away) {
            return passed_at(s, scene, {direction.x * (kHalf + away), direction.y * (kHalf + away)});
        };
        CHECK(at(-kHalf) < 5);  // below it
        // A high wall beside a point takes half of an even sky; in levels that leaves about three quarters.
        CHECK(at(0.03f) > 110);
        CHECK(at(0.03f) < 210);
        CHECK(at(0.15f) > at(0.03f));
        CHECK(at(0.4f) > at(0.15f));
    }
    const uint32_t last = s.pieces * s.side - 1;
    for (uint32_t k = 0; k <= last; ++k)
        for (const size_t texel : {s.texel(k, 0), s.texel(k, last), s.texel(0, k), s.texel(last, k)})
            CHECK(s.passed[texel] > 250);
}

TEST_CASE("ground shadow: a lamp throws it to the other side")
{
    const Scene scene = tower(0.02f, Fixture(DirectionalLight{normalized(Vec3{1, 0, 2}), grey(3)}));
    const GroundShadow s = shadow_of(scene);
    CHECK(passed_at(s, scene, {-kHalf - 0.2f, 0}) < 100);
    CHECK(passed_at(s, scene, {kHalf + 0.2f, 0}) > 240);
}

TEST_CASE("ground shadow: a ball that touches its sphere has none, and the bake says so")
{
    SceneMaker maker;
    maker.ball(maker.add(diffuse(grey(0.5f))), {0, 0, 0}, 1);
    const GroundShadow s = shadow_of(maker.make(constant_environment(1)));
    CHECK(!s.is_there());
    REQUIRE(s.notes.size() == 1);
    CHECK_THAT(s.notes[0], Catch::Contains("no room"));
}

TEST_CASE(
    "ground shadow: a field has it at the lowest point and nowhere above, in the same sphere and the same triangles")
{
    const Scene scene = tower(1);
    SurfaceSettings settings = with_ground();
    const std::string with = baked(scene, settings);
    settings.ground = false;
    const std::string without = baked(scene, settings);
    const auto opened = [](const std::string& file) {
        SurfaceField field;
        REQUIRE(open_surface<SurfaceFeatures::all>(reinterpret_cast<const uint8_t*>(file.data()), file.size(), field) ==
                FieldError::none);
        return field;
    };
    const SurfaceField field = opened(with), plain = opened(without);
    CHECK(field.patch_count == plain.patch_count);
    CHECK(plain.see_through_count == 0);
    CHECK(std::equal(field.sphere, field.sphere + 16, plain.sphere));
    SurfaceField alone;  // as firmware without see-through patches has it
    REQUIRE(open_surface(reinterpret_cast<const uint8_t*>(with.data()), with.size(), alone) == FieldError::none);
    CHECK(alone.patch_count == plain.patch_count);
    REQUIRE(field.see_through_count > 0);
    int32_t lowest = INT32_MAX;
    for (uint32_t v = 0; v < plain.vertex_count; ++v)
        lowest = std::min<int32_t>(lowest, detail::surface_vertex(plain, v).z);
    for (uint32_t p = field.patch_count; p < field.patch_count + field.see_through_count; ++p) {
        const detail::SurfacePatch patch = detail::surface_patch(field, p);
        detail::VertexQ14 corner[3];
        for (uint32_t k = 0; k < 3; ++k) {
            corner[k] = detail::surface_vertex(field, patch.corner[k]);
            CHECK(std::abs(corner[k].z - lowest) < 200);  // 0.012 radii: the mesh strays by more
        }
        const int64_t turn = int64_t{corner[1].x - corner[0].x} * (corner[2].y - corner[0].y) -
                             int64_t{corner[1].y - corner[0].y} * (corner[2].x - corner[0].x);
        CHECK(turn > 0);  // it faces up, and is not drawn from below
    }
}

TEST_CASE("ground shadow: panes keep most of the palette that both share")
{
    SceneMaker maker;
    maker.box(maker.add(diffuse(grey(0.1f))), {-kHalf, -kHalf, 0}, {kHalf, kHalf, kHeight});
    Material pane = diffuse(grey(0.5f));
    pane.opacity = 0.3f;
    pane.finish();
    maker.quad(maker.add(pane), {-1, 0.5f, 0}, {1, 0.5f, 0}, {1, 0.5f, 1}, {-1, 0.5f, 1});
    const std::string file = baked(maker.make(constant_environment(1)), with_ground());
    SurfaceField field;
    REQUIRE(open_surface<SurfaceFeatures::all>(reinterpret_cast<const uint8_t*>(file.data()), file.size(), field) ==
            FieldError::none);
    const uint8_t* const last =
        field.see_through + detail::format::see_through::kPaletteAt + 255 * detail::format::see_through::kEntryBytes;
    CHECK(int{last[0]} == 0);
    CHECK(int{last[3]} == 255);
    CHECK(open_surface(reinterpret_cast<const uint8_t*>(file.data()), file.size(), field) == FieldError::see_through);
}

}  // namespace lumi::baker::testing
