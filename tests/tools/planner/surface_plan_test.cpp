// SPDX-License-Identifier: MIT
// From a size to the triangles and texels of a surface field.
#include "planner/surface_plan.h"

#include <catch2/catch.hpp>

#include "planner/no_plan.h"
#include "planner/ram.h"
#include "support/small_surface.h"

namespace lumi::planner
{

namespace
{

SurfacePlan planned(const SurfaceTask& task)
{
    return plan_surface(tools::test::cube_scene(), task, {});
}

SurfaceTask surface_task_of(uint64_t bytes)
{
    SurfaceTask task;
    task.budget_bytes = bytes;
    return task;
}

}  // namespace

TEST_CASE("a surface plan fills its size, and a larger one has more of everything")
{
    uint32_t triangles = 0;
    float density = 0;
    for (const uint64_t bytes : {12'000u, 30'000u, 60'000u}) {
        const SurfacePlan plan = planned(surface_task_of(bytes));
        INFO(bytes << " bytes: " << options_of(plan));
        CHECK(plan.most_bytes <= bytes);
        CHECK(plan.most_bytes > bytes * 9 / 10);
        CHECK(plan.draft->triangles() >= triangles);
        CHECK(plan.settings.texels_per_radius > density);
        triangles = plan.draft->triangles();
        density = plan.settings.texels_per_radius;
    }
}

TEST_CASE("edges get longer where the mesh would take half of the bytes")
{
    for (const uint64_t bytes : {30'000u, 90'000u}) {
        const SurfacePlan plan = planned(surface_task_of(bytes));
        INFO(bytes << " bytes: " << options_of(plan));
        CHECK(plan.draft->most_bytes(1) <= bytes / 2);
    }
}

TEST_CASE("what is set by hand stays in a surface plan")
{
    SurfaceTask task = surface_task_of(30'000);
    task.settings.triangles = 60;
    task.settings.longest_edge = 0.8f;
    task.triangles_by_hand = task.edge_by_hand = true;
    const SurfacePlan mesh = planned(task);
    CHECK(mesh.settings.triangles == 60);
    CHECK(mesh.settings.longest_edge == 0.8f);
    CHECK(mesh.most_bytes > 28'000);
    task.settings.texels_per_radius = 8;
    task.density_by_hand = true;
    const SurfacePlan all = planned(task);
    CHECK(all.settings.texels_per_radius == 8);
    CHECK(all.most_bytes < 10'000);
    CHECK(options_of(all) == "--layout surface --triangles 60 --longest-edge 0.8 --texel-density 8");
}

TEST_CASE("a limit of RAM makes the mesh coarser, and the plan tells its RAM and what is given up")
{
    SurfaceTask task = surface_task_of(60'000);
    task.ram = RamLimit{1'000'000, {240, 240, 8}};
    const SurfacePlan roomy = planned(task);
    CHECK(roomy.triangles_without_ram == 0);
    const uint64_t least = ram_of(host::SurfaceCounts{0, 0, SurfaceMode::antialiased, 0}, task.ram->screen).all();
    for (const uint64_t quarters : {3u, 2u}) {
        task.ram->bytes = least + (roomy.ram_bytes - least) * quarters / 4;
        const SurfacePlan tight = planned(task);
        INFO(options_of(tight));
        CHECK(tight.ram_bytes <= task.ram->bytes);
        CHECK(tight.draft->triangles() < roomy.draft->triangles());
        CHECK(tight.triangles_without_ram == roomy.draft->triangles());
        CHECK(tight.settings.texels_per_radius >= roomy.settings.texels_per_radius);
        CHECK(tight.most_bytes <= task.budget_bytes);
    }
    task.ram->bytes = least;
    CHECK_THROWS_WITH(planned(task), Catch::Contains(std::to_string(least) + " without any") &&
                                         Catch::Contains("give more --ram, or fewer --rows"));
}

TEST_CASE("the RAM of a plan is that of the field that it bakes")
{
    SurfaceTask task = surface_task_of(15'000);
    task.ram = RamLimit{1'000'000, {}};
    SurfacePlan plan = planned(task);
    plan.settings.paths_per_texel = 1;
    const baker::SurfaceBake baked =
        baker::surface_field(tools::test::cube_scene(), plan.settings, {}, plan.draft.get());
    SeeThroughField field;
    REQUIRE(open_surface(baked.file.data(), baked.file.size(), field) == FieldError::none);
    const host::SurfaceCounts counts = {field.vertex_count, field.patch_count, SurfaceMode::antialiased,
                                        field.see_through_count};
    CHECK(ram_of(counts, task.ram->screen).all() == plan.ram_bytes);
}

TEST_CASE("a size that no surface field fits into ends with the smallest that works")
{
    try {
        planned(surface_task_of(3'000));
        FAIL("3 kB hold no surface field");
    } catch (const NoPlan& none) {
        const std::string text = none.what(), before = "the smallest that works takes ";
        const size_t at = text.find(before);
        REQUIRE(at != std::string::npos);
        const uint64_t least = std::stoul(text.substr(at + before.size()));
        CHECK(least > 3'000);
        CHECK(planned(surface_task_of(least)).most_bytes <= least);
    }
}

}  // namespace lumi::planner
