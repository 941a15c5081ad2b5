// SPDX-License-Identifier: MIT
// From limits to the mesh and texels of a surface field.
#include <catch2/catch.hpp>

#include "lumi/surface/field.h"
#include "lumi/surface/format.h"
#include "mesh/patch_mesh.h"
#include "surface/surface_scenes.h"

namespace lumi::baker::testing
{
namespace
{

constexpr SurfaceLimits kByHand = {UINT32_MAX, std::nullopt, false, false, false};

// Where chrome is asked for, a ball of it looks out of the other one and touches the unit sphere.
Scene ball(const Material& material, float chrome_radius = 0)
{
    SceneMaker maker;
    maker.ball(maker.add(material), {0, 0, 0}, 0.9f, 16);
    if (chrome_radius > 0) maker.ball(maker.add(metal(grey(0.8f), 0.1f)), {1 - chrome_radius, 0, 0}, chrome_radius, 16);
    maker.span_unit_sphere();
    return maker.make(constant_environment(1));
}

// A lattice of thin sticks, of which none can be seen whole with few triangles.
Scene sticks()
{
    SceneMaker maker;
    const uint32_t matt = maker.add(diffuse(grey(0.5f)));
    constexpr int kSide = 6;
    for (int k = 0; k < kSide * kSide; ++k) {
        const float x = 0.2f * static_cast<float>(k % kSide) - 0.5f, y = 0.2f * static_cast<float>(k / kSide) - 0.5f;
        const float z = k % 3 == 0 ? -0.2f : -0.3f;
        maker.box(matt, {x, y, z}, {x + 0.02f, y + 0.02f, z + 0.5f});
    }
    maker.span_unit_sphere();
    return maker.make(constant_environment(1));
}

// Steps of meshes that other plans have made are found in the file of stages.
SurfacePlan plan_of(const SurfaceLimits& limits, SurfaceSettings settings = {})
{
    static const Scene scene = ball(glossy(grey(0.5f), 0.2f));
    static const ScratchFolder folder;
    settings.threads = 1;
    return plan_surface(scene, settings, limits, {}, folder.at("f.lumi"));
}

SurfaceLimits within(uint64_t bytes)
{
    SurfaceLimits limits;
    limits.bytes = bytes;
    return limits;
}

uint64_t least_ram(const host::ScreenSize& screen)
{
    return uint64_t{host::surface_view_bytes<PixelRgb565>({0, 0, SurfaceMode::antialiased, 0}, screen)} +
           host::stripe_pixel_bytes<PixelRgb565>(screen);
}

}  // namespace

TEST_CASE("a surface plan fills its size, and a larger one has more of everything")
{
    uint32_t triangles = 0;
    float density = 0;
    for (const uint64_t bytes : {12'000u, 30'000u, 60'000u}) {
        const SurfacePlan plan = plan_of(within(bytes));
        INFO(bytes << " bytes: " << plan.settings.triangles << " triangles, " << plan.settings.texels_per_radius);
        REQUIRE(plan.mesh);
        CHECK(plan.most_bytes <= bytes);
        CHECK(plan.most_bytes > bytes * 9 / 10);
        CHECK(plan.triangles >= triangles);
        CHECK(plan.settings.texels_per_radius > density);
        triangles = plan.triangles;
        density = plan.settings.texels_per_radius;
    }
}

TEST_CASE("triangles that show nothing are left out of a surface plan, unless it is to fill its size")
{
    constexpr int kSide = 12;
    constexpr float kStep = 1.0f / kSide;
    SceneMaker maker;
    const uint32_t matt = maker.add(diffuse(grey(0.5f)));
    for (int k = 0; k < 6 * kSide * kSide; ++k) {  // the faces of a cube, in small squares
        const float out = k % 2 == 0 ? 0.5f : -0.5f, x = kStep * static_cast<float>(k / 6 % kSide) - 0.5f,
                    y = kStep * static_cast<float>(k / 6 / kSide) - 0.5f;
        const auto at = [&](float a, float b) {
            return k % 6 / 2 == 0 ? Vec3{a, b, out} : k % 6 / 2 == 1 ? Vec3{b, out, a} : Vec3{out, a, b};
        };
        maker.quad(matt, at(x, y), at(x + kStep, y), at(x + kStep, y + kStep), at(x, y + kStep));
    }
    maker.span_unit_sphere();
    const Scene cube = maker.make(constant_environment(1));
    SurfaceSettings settings;
    const uint32_t spared = plan_surface(cube, settings, within(500'000)).triangles;
    settings.fills = true;
    const uint32_t filled = plan_surface(cube, settings, within(500'000)).triangles;
    CHECK(filled >= 12 * kSide * kSide);
    CHECK(spared < filled * 4 / 5);
}

TEST_CASE("edges get longer where the mesh would take half of the bytes")
{
    for (const uint64_t bytes : {30'000u, 90'000u}) {
        SurfaceSettings coarse = plan_of(within(bytes)).settings;
        coarse.texels_per_radius = 1;
        CHECK(plan_of(kByHand, coarse).most_bytes <= bytes / 2);
    }
}

TEST_CASE("bytes of view tables go to triangles and texels where a scene is matt")
{
    const Scene matt = ball(diffuse(grey(0.5f))), dull = ball(glossy(grey(0.7f), 0.8f));
    const SurfacePlan shiny = plan_of(within(20'000));
    for (const Scene* scene : {&matt, &dull}) {
        const SurfacePlan plan = plan_surface(*scene, {}, within(20'000), {}, {});
        REQUIRE(plan.mesh);
        CHECK(plan.settings.triangles > 1.4 * shiny.settings.triangles);
        CHECK(most_viewed_vertices(plan.mesh->mesh) < plan.mesh->mesh.positions.size() / 2);
        CHECK(plan.most_bytes <= 20'000);
    }
    CHECK(most_viewed_vertices(shiny.mesh->mesh) == shiny.mesh->mesh.positions.size());
}

TEST_CASE("a scene is matt if little of its area shines and dull skins lie on bright bodies")
{
    const auto is_planned_as_matt = [](const Scene& scene) {
        return plan_surface(scene, {}, within(20'000), {}, {}).mesh->mesh.is_matt != 0;
    };
    CHECK(is_planned_as_matt(ball(diffuse(grey(0.5f)), 0.2f)));
    CHECK_FALSE(is_planned_as_matt(ball(diffuse(grey(0.5f)), 0.5f)));
    CHECK_FALSE(is_planned_as_matt(ball(glossy(grey(0.4f), 0.8f))));
}

TEST_CASE("what is set by hand stays in a surface plan")
{
    SurfaceSettings settings;
    settings.triangles = 60;
    settings.longest_edge = 0.8f;
    const SurfacePlan mesh = plan_of({30'000, std::nullopt, false, false, true}, settings);
    CHECK(mesh.settings.triangles == 60);
    CHECK(mesh.settings.longest_edge == 0.8f);
    CHECK(mesh.most_bytes > 28'000);
    settings.texels_per_radius = 8;
    const SurfacePlan all = plan_of({30'000, std::nullopt, false, false, false}, settings);
    CHECK(all.settings.texels_per_radius == 8);
    CHECK(all.most_bytes < 15'000);
}

TEST_CASE("a limit of RAM makes the mesh coarser, and the plan tells its RAM and what is given up")
{
    SurfaceLimits limits = within(60'000);
    limits.ram = RamLimit{1'000'000, {240, 240, 8}};
    const SurfacePlan roomy = plan_of(limits);
    CHECK(roomy.triangles_without_ram == 0);
    const uint64_t least = least_ram(limits.ram->screen);
    for (const uint64_t quarters : {3u, 2u}) {
        limits.ram->bytes = least + (roomy.ram_bytes - least) * quarters / 4;
        const SurfacePlan tight = plan_of(limits);
        INFO(quarters << " quarters");
        CHECK(tight.ram_bytes <= limits.ram->bytes);
        CHECK(tight.triangles < roomy.triangles);
        CHECK(tight.triangles_without_ram == roomy.triangles);
        CHECK(tight.settings.texels_per_radius >= roomy.settings.texels_per_radius);
        CHECK(tight.most_bytes <= limits.bytes);
    }
    limits.ram->bytes = least;
    const SurfacePlan none = plan_of(limits);
    CHECK_FALSE(none.mesh);
    CHECK_THAT(none.against, Catch::Contains(std::to_string(least) + " without any") &&
                                 Catch::Contains("give more --ram, or fewer --rows"));
}

TEST_CASE(
    "a plan tells the RAM, the mesh and at most how many bytes of the field, which is the one of a bake without a plan")
{
    const Scene scene = tiny_scene();
    SurfaceLimits limits = kByHand;
    limits.ram = RamLimit{1'000'000, {}};
    const SurfacePlan plan = plan_surface(scene, tiny_surface(), limits);
    const SurfaceBake bake = surface_field(scene, plan);
    SurfaceField field;
    REQUIRE(open_surface(bake.file.data(), bake.file.size(), field) == FieldError::none);
    const host::SurfaceCounts counts = {field.vertex_count, field.patch_count, SurfaceMode::antialiased, 0};
    CHECK(plan.ram_bytes ==
          uint64_t{host::surface_view_bytes<PixelRgb565>(counts, {})} + host::stripe_pixel_bytes<PixelRgb565>({}));
    CHECK(plan.triangles == bake.triangles);
    CHECK(plan.loss.missed == bake.loss.missed);
    CHECK(bake.file.size() <= plan.most_bytes);
    CHECK((bake.file == surface_field(scene, {tiny_surface()}).file));  // which makes its own mesh
    // Most that is left is less than what finer codes take, or planned for tables that pay nothing.
    const uint64_t tables = detail::format::view_colours_bytes(3) + bake.vertices * detail::format::view_bytes(3);
    CHECK(plan.most_bytes - bake.file.size() <=
          tables + detail::format::kEntryBytes + 2 * detail::format::kSectionAlignment);
}

TEST_CASE("a size that no surface field fits into ends with the smallest that works")
{
    const SurfacePlan none = plan_of(within(3'000));
    REQUIRE_FALSE(none.mesh);
    const std::string text = none.against, before = "the smallest that works takes ";
    const size_t at = text.find(before);
    REQUIRE(at != std::string::npos);
    const uint64_t least = std::stoul(text.substr(at + before.size()));
    CHECK(least > 3'000);
    CHECK(plan_of(within(least)).most_bytes <= least);
}

TEST_CASE("a mesh that thin parts would tear gets more triangles than others of so many bytes")
{
    constexpr uint64_t kBytes = 36'000;
    constexpr uint32_t kSticks = 36, kOfBox = 12;
    SurfaceSettings settings;
    settings.threads = 2;
    const SurfacePlan plan = plan_surface(sticks(), settings, within(kBytes));
    INFO(plan.settings.triangles << " triangles; " << plan.against);
    REQUIRE(plan.mesh);
    CHECK(plan.against.empty());
    CHECK(plan.enough_bytes == 0);
    CHECK(plan.most_bytes <= kBytes);
    CHECK(plan.settings.triangles > kBytes / 90);  // where others begin
    CHECK(plan.triangles >= kSticks * kOfBox);
}

}  // namespace lumi::baker::testing
