// SPDX-License-Identifier: MIT
// From a size to the triangles and texels of a surface field.
#include "planner/surface_plan.h"

#include <catch2/catch.hpp>

#include "planner/no_plan.h"
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
