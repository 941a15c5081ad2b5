// SPDX-License-Identifier: MIT
// What the planner of chord fields may choose from, and how a plan is made as large as its budget.
#include "planner/fit.h"

#include <catch2/catch.hpp>

#include "lumi/baker/bake.h"
#include "lumi/lattice.h"

namespace lumi::planner
{

namespace
{

Task task_of(uint64_t budget)
{
    Task task;
    task.budget_bytes = budget;
    return task;
}

Plan start_plan(const Task& task)
{
    const auto families = families_of(task);
    return plan_of(task, families, start_of(families, 0));
}

uint64_t bytes_of(const Plan& plan)
{
    return baker::field_file_bytes(plan.chord);
}

// Every plan that the search could reach, one coordinate away from the start.
std::vector<Plan> plans_around_start(const Task& task)
{
    const auto families = families_of(task);
    std::vector<Plan> plans = {start_plan(task)};
    for (const Candidate& beside : neighbours_of(families, start_of(families, 0)))
        plans.push_back(plan_of(task, families, beside));
    return plans;
}

// Counts how often it is asked.
struct Counted {
    size_t calls = 0;
    BytesOf of = [this](const Plan& plan) {
        ++calls;
        return bytes_of(plan);
    };
};

}  // namespace

TEST_CASE("a planner starts from as many directions as origins, a byte a texel")
{
    const Plan plan = start_plan(task_of(1'000'000));
    CHECK(plan.chord.origins == plan.chord.directions);
    CHECK(plan.chord.texel == format::TexelFormat::palette8);
    CHECK(plans_around_start(task_of(1'000'000)).size() == 4);  // two shapes and a texel beside it
}

TEST_CASE("what is set by hand is the same in every plan")
{
    Task task = task_of(1'000'000);
    task.by_hand.origins = 100;
    task.by_hand.texel = format::TexelFormat::rgb888;
    task.by_hand.cap = [](uint32_t origins) { return origins / 2; };
    const auto plans = plans_around_start(task);
    CHECK(plans.size() == 1);
    CHECK(plans[0].chord.origins == 100);
    CHECK(plans[0].chord.used_origins == 50);
    CHECK(plans[0].chord.texel == format::TexelFormat::rgb888);
}

TEST_CASE("one parameter set by hand stays in all plans while others move")
{
    Task task = task_of(1'000'000);
    task.by_hand.texel = format::TexelFormat::luma8;
    const auto plans = plans_around_start(task);
    CHECK(plans.size() > 1);
    for (const Plan& plan : plans) CHECK(plan.chord.texel == format::TexelFormat::luma8);
}

TEST_CASE("origins are capped only where views from below do not count")
{
    Task task = task_of(1'000'000);
    for (const Plan& plan : plans_around_start(task)) CHECK(plan.chord.used_origins == plan.chord.origins);
    task.views = quality::ViewSet::upper;
    CHECK(start_plan(task).chord.used_origins < start_plan(task).chord.origins);
}

TEST_CASE("a field is the largest that fits, found by few sizes")
{
    for (const uint64_t budget : {30'000u, 100'000u, 1'000'000u, 30'000'000u}) {
        const Task task = task_of(budget);
        Counted counted;
        const Fit fit = fit_plan(task, start_plan(task), counted.of, 0);
        INFO("budget " << budget << ", calls " << counted.calls);
        REQUIRE(fit.fits);
        CHECK(fit.bytes == bytes_of(fit.plan));
        CHECK(fit.bytes <= budget);
        Plan larger = fit.plan;
        larger.chord.used_origins = ++larger.chord.origins;
        ++larger.chord.directions;
        CHECK(bytes_of(larger) > budget);
        CHECK(counted.calls <= 16);
    }
}

TEST_CASE("with slack, fewer sizes are asked for, and the budget is used up to it")
{
    const Task task = task_of(1'000'000);
    Counted counted;
    const Fit fit = fit_plan(task, start_plan(task), counted.of, 0.02);
    CHECK(fit.bytes <= 1'000'000);
    CHECK(fit.bytes >= 980'000);
    CHECK(counted.calls <= 4);
}

TEST_CASE("a plan that cannot fit tells its smallest size, one that cannot be baked why")
{
    const Task task = task_of(100);
    const Fit large = fit_plan(task, start_plan(task), bytes_of, 0);
    CHECK_FALSE(large.fits);
    CHECK(large.bytes > 100);
    const Fit never = fit_plan(
        task, start_plan(task), [](const Plan&) -> uint64_t { throw baker::BakeError("no such thing"); }, 0);
    CHECK_FALSE(never.fits);
    CHECK(never.note == "no such thing");
}

TEST_CASE("sizes that the format does not hold are passed over")
{
    const Task task = task_of(3'000'000);
    const BytesOf limited = [](const Plan& plan) {
        if (plan.chord.origins > 123) throw baker::BakeError("more than the format holds");
        return bytes_of(plan);
    };
    const Fit fit = fit_plan(task, start_plan(task), limited, 0);
    CHECK(fit.fits);
    CHECK(fit.plan.chord.origins == 123);
}

TEST_CASE("sizes set by hand are taken as they are, fitting or not")
{
    Task task = task_of(100'000);
    task.by_hand.origins = 100;
    task.by_hand.directions = 200;
    const Fit fit = fit_plan(task, start_plan(task), bytes_of, 0);
    CHECK(fit.fits);
    CHECK(fit.plan.chord.directions == 200);
    task.by_hand.directions = 2000;
    CHECK_FALSE(fit_plan(task, start_plan(task), bytes_of, 0).fits);
}

TEST_CASE("a chord field fills its budget in every shape")
{
    const Task task = task_of(500'000);
    for (const Plan& plan : plans_around_start(task)) {
        const Fit fit = fit_plan(task, plan, bytes_of, 0);
        REQUIRE(fit.fits);
        CHECK(fit.bytes <= 500'000);
        CHECK(fit.bytes >= 490'000);
    }
    Task by_hand = task;
    by_hand.by_hand.origins = 300;
    const Fit fit = fit_plan(by_hand, start_plan(by_hand), bytes_of, 0);
    CHECK(fit.plan.chord.origins == 300);
    CHECK(fit.bytes >= 490'000);
}

TEST_CASE("a plan's options set the same by hand")
{
    Plan plan;
    plan.chord.origins = 700;
    plan.chord.used_origins = 630;
    plan.chord.directions = 800;
    plan.chord.texel = format::TexelFormat::palette8;
    CHECK(text_of(plan) == "chord, 700 origins (uppermost 630), 800 directions, palette8");
    CHECK(options_of(plan) == "--layout chord --origins 700 --cap 630 --directions 800 --texel palette8");
}

}  // namespace lumi::planner
