// SPDX-License-Identifier: MIT
// From a size to the points of a chord field.
#include "planner/chord_plan.h"

#include <catch2/catch.hpp>

namespace lumi::planner
{

namespace
{

ChordTask task_of(uint64_t budget)
{
    ChordTask task;
    task.budget_bytes = budget;
    task.settings.texel = TexelFormat::palette8;
    return task;
}

}  // namespace

TEST_CASE("a chord plan is the largest that fits, with as many directions as origins")
{
    for (const uint64_t budget : {30'000u, 100'000u, 1'000'000u, 30'000'000u}) {
        baker::BakeSettings plan = plan_chord(task_of(budget));
        INFO("budget " << budget << ": " << text_of(plan));
        CHECK(plan.origins == plan.directions);
        CHECK(plan.texel == TexelFormat::palette8);
        CHECK(baker::field_file_bytes(plan) <= budget);
        ++plan.origins;
        ++plan.directions;
        CHECK(baker::field_file_bytes(plan) > budget);
    }
}

TEST_CASE("what is set by hand stays in a chord plan")
{
    ChordTask task = task_of(500'000);
    task.settings.texel = TexelFormat::rgb888;
    task.settings.origins = 300;
    task.origins_by_hand = true;
    task.cap = [](uint32_t origins) { return origins / 2; };
    const baker::BakeSettings plan = plan_chord(task);
    CHECK(plan.texel == TexelFormat::rgb888);
    CHECK(plan.origins == 300);
    CHECK(plan.used_origins == 150);
    CHECK(baker::field_file_bytes(plan) <= 500'000);
    CHECK(baker::field_file_bytes(plan) >= 490'000);
    task.settings.directions = 200;
    task.directions_by_hand = true;
    CHECK(plan_chord(task).directions == 200);
    task.settings.directions = 20'000;
    CHECK_THROWS_AS(plan_chord(task), NoPlan);
}

TEST_CASE("a chord field that cannot fit tells its smallest size, and that size works")
{
    try {
        plan_chord(task_of(100));
        FAIL("100 bytes hold no field");
    } catch (const NoPlan& none) {
        const std::string text = none.what(), before = "the smallest that works takes ";
        REQUIRE(text.find(before) != std::string::npos);
        const uint64_t least = std::stoul(text.substr(text.find(before) + before.size()));
        CHECK(baker::field_file_bytes(plan_chord(task_of(least))) == least);
    }
}

TEST_CASE("a chord plan's options set the same by hand")
{
    baker::BakeSettings plan;
    plan.origins = 700;
    plan.used_origins = 630;
    plan.directions = 800;
    plan.texel = TexelFormat::palette8;
    CHECK_THAT(text_of(plan), Catch::StartsWith("700 origins (uppermost 630), 800 directions, palette8, "));
    CHECK(options_of(plan) == "--layout chord --origins 700 --cap 630 --directions 800 --texel palette8");
}

}  // namespace lumi::planner
