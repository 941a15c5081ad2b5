// SPDX-License-Identifier: MIT
// What the planner may choose from, and how a plan is made as large as its budget.
#include "planner/fit.h"

#include <catch2/catch.hpp>

#include "lumi/baker/bake.h"

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

Plan start_plan(const Task& task, size_t family)
{
    const auto families = families_of(task);
    return plan_of(task, families, start_of(families, family));
}

// Something like a guided file: fixed parts, and texels that grow as the square of the chart.
uint64_t made_up_bytes(const Plan& plan)
{
    const uint64_t size = plan.guided.chart_size;
    return 20000 + 37 * size + plan.guided.origins * (size * size / 4);
}

// Every plan that the search could reach, one coordinate away from the start.
std::vector<Plan> plans_around_start(const Task& task)
{
    const auto families = families_of(task);
    std::vector<Plan> plans;
    for (size_t f = 0; f < families.size(); ++f) {
        plans.push_back(plan_of(task, families, start_of(families, f)));
        for (const Candidate& beside : neighbours_of(families, start_of(families, f)))
            plans.push_back(plan_of(task, families, beside));
    }
    return plans;
}

}  // namespace

TEST_CASE("a planner starts from all layouts, and from larger parts with more flash")
{
    CHECK(families_of(task_of(1'000'000)).size() == kLayouts);
    const Plan small = start_plan(task_of(250'000), 0), large = start_plan(task_of(4'000'000), 0);
    CHECK(small.guided.origins < large.guided.origins);
    CHECK(small.guided.mean_resolution < large.guided.mean_resolution);
    CHECK(small.guided.proxy_triangles <= large.guided.proxy_triangles);
}

TEST_CASE("what is set by hand is the same in every plan")
{
    Task task = task_of(1'000'000);
    ByHand& set = task.by_hand;
    set.origins = 100;
    set.triangles = 777;
    set.mean_resolution = 50;
    set.mean_format = format::MeanFormat::rgb565;
    set.texel = format::GuidedTexel::index8;
    set.occlusion = false;
    set.jitter = 0.25f;
    set.cap = [](uint32_t origins) { return origins / 2; };
    const auto plans = plans_around_start(task);
    CHECK(plans.size() == 1);
    for (const Plan& plan : plans) {
        CHECK(plan.layout == Layout::guided);
        CHECK(plan.guided.origins == 100);
        CHECK(plan.guided.used_origins == 50);
        CHECK(plan.guided.proxy_triangles == 777);
        CHECK(plan.guided.mean_resolution == 50);
        CHECK(plan.guided.mean_format == format::MeanFormat::rgb565);
        CHECK(plan.guided.texel == format::GuidedTexel::index8);
        CHECK_FALSE(plan.guided.occlusion);
        CHECK(plan.guided.jitter == 0.25f);
    }
}

TEST_CASE("texels in blocks are planned of guided fields, and of these alone where they are set by hand")
{
    Task task = task_of(1'000'000);
    task.by_hand.texel = format::GuidedTexel::vq8;
    const auto plans = plans_around_start(task);
    CHECK(plans.size() > 1);
    for (const Plan& plan : plans) {
        CHECK(plan.layout == Layout::guided);
        CHECK(plan.guided.texel == format::GuidedTexel::vq8);
    }
    task.by_hand.texel = {};
    size_t in_blocks = 0;
    for (const Plan& plan : plans_around_start(task)) {
        if (plan.guided.texel != format::GuidedTexel::vq8) continue;
        CHECK(plan.layout == Layout::guided);
        CHECK(text_of(plan).find("vq8 texels") != std::string::npos);
        CHECK(options_of(plan).find("--texels vq8") != std::string::npos);
        ++in_blocks;
    }
    CHECK(in_blocks == 1);
}

TEST_CASE("a search ends with texels in blocks where these look best, and nowhere else")
{
    const Task task = task_of(250'000);
    const auto families = families_of(task);
    for (const double gain_db : {0.4, -0.4}) {
        const auto trial = [&](const Candidate& candidate) {
            const Plan plan = plan_of(task, families, candidate);
            const bool in_blocks = plan.layout == Layout::guided && plan.guided.texel == format::GuidedTexel::vq8;
            const double layout_db = plan.layout == Layout::guided ? 31 : 20;
            return Outcome{true, layout_db + (in_blocks ? gain_db : 0), 1, ""};
        };
        const SearchResult result = search(families, trial, {});
        REQUIRE(result.best);
        const Plan best = plan_of(task, families, result.tried[*result.best].candidate);
        CHECK((best.guided.texel == format::GuidedTexel::vq8) == (gain_db > 0));
    }
}

TEST_CASE("one parameter set by hand stays in all plans while others move")
{
    Task task = task_of(1'000'000);
    task.by_hand.origins = 100;
    const auto plans = plans_around_start(task);
    CHECK(plans.size() > 10);
    for (const Plan& plan : plans)
        CHECK((plan.layout == Layout::chord ? plan.chord.origins : plan.guided.origins) == 100);
    task.by_hand = {};
    task.by_hand.mean_resolution = 0;
    for (const Plan& plan : plans_around_start(task)) CHECK(plan.guided.mean_resolution == 0);
}

TEST_CASE("a layout that has no use for what is set by hand is out")
{
    ByHand set;
    set.mean_resolution = 96;
    CHECK(layouts_of(set) == std::vector<Layout>{Layout::guided});
    set.directions = 1000;
    CHECK(layouts_of(set).empty());
    set = {};
    set.chart_size = 100;
    CHECK(layouts_of(set) == std::vector<Layout>{Layout::guided, Layout::focus});
    set.layout = Layout::focus;
    CHECK(layouts_of(set) == std::vector<Layout>{Layout::focus});
    set = {};
    set.chord_texel = format::TexelFormat::rgb888;
    CHECK(layouts_of(set) == std::vector<Layout>{Layout::chord});
}

TEST_CASE("origins are capped only where views from below do not count")
{
    Task task = task_of(1'000'000);
    for (const Plan& plan : plans_around_start(task))
        if (plan.layout != Layout::chord) CHECK(plan.guided.used_origins == plan.guided.origins);
    task.views = quality::ViewSet::upper;
    CHECK(start_plan(task, 0).guided.used_origins < start_plan(task, 0).guided.origins);
}

TEST_CASE("a chart is the largest that fits, found by few sizes")
{
    for (const uint64_t budget : {30'000u, 100'000u, 1'000'000u, 3'000'000u}) {
        const Task task = task_of(budget);
        size_t calls = 0;
        const BytesOf bytes_of = [&](const Plan& plan) {
            ++calls;
            return made_up_bytes(plan);
        };
        const Fit fit = fit_plan(task, start_plan(task, 0), bytes_of, 0);
        INFO("budget " << budget << ", calls " << calls);
        REQUIRE(fit.fits);
        CHECK(made_up_bytes(fit.plan) <= budget);
        Plan larger = fit.plan;
        ++larger.guided.chart_size;
        CHECK((larger.guided.chart_size > format::kMaxChart || made_up_bytes(larger) > budget));
        CHECK(fit.bytes == made_up_bytes(fit.plan));
        CHECK(calls <= 12);
    }
}

TEST_CASE("with slack, fewer sizes are asked for, and the budget is used up to it")
{
    const Task task = task_of(1'000'000);
    size_t calls = 0;
    const Fit fit = fit_plan(
        task, start_plan(task, 0),
        [&](const Plan& plan) {
            ++calls;
            return made_up_bytes(plan);
        },
        0.02);
    CHECK(made_up_bytes(fit.plan) <= 1'000'000);
    CHECK(made_up_bytes(fit.plan) >= 980'000);
    CHECK(calls <= 4);
}

TEST_CASE("a plan that cannot fit tells its smallest size, one that cannot be baked why")
{
    const Task task = task_of(20'000);
    const Fit large = fit_plan(task, start_plan(task, 0), made_up_bytes, 0);
    CHECK_FALSE(large.fits);
    Plan smallest = start_plan(task, 0);
    smallest.guided.chart_size = format::kMinChart;
    CHECK(large.bytes == made_up_bytes(smallest));

    const Fit never = fit_plan(
        task, start_plan(task, 0), [](const Plan&) -> uint64_t { throw baker::BakeError("no such thing"); }, 0);
    CHECK_FALSE(never.fits);
    CHECK(never.note == "no such thing");
}

TEST_CASE("sizes that the format does not hold are passed over")
{
    const Task task = task_of(3'000'000);
    const BytesOf bytes_of = [](const Plan& plan) {
        if (plan.guided.chart_size > 123) throw baker::BakeError("more texels than an origin may have");
        return made_up_bytes(plan);
    };
    const Fit fit = fit_plan(task, start_plan(task, 0), bytes_of, 0);
    CHECK(fit.fits);
    CHECK(fit.plan.guided.chart_size == 123);
}

TEST_CASE("sizes set by hand are taken as they are, fitting or not")
{
    Task task = task_of(1'000'000);
    task.by_hand.chart_size = 60;
    const Fit fit = fit_plan(task, start_plan(task, 0), made_up_bytes, 0);
    CHECK(fit.fits);
    CHECK(fit.plan.guided.chart_size == 60);
    task.by_hand.chart_size = 399;
    CHECK_FALSE(fit_plan(task, start_plan(task, 0), made_up_bytes, 0).fits);
}

TEST_CASE("a chord field fills its budget in every shape")
{
    const BytesOf bytes_of = [](const Plan& plan) { return baker::field_file_bytes(plan.chord); };
    const Task task = task_of(500'000);
    const auto families = families_of(task);
    for (const Candidate& candidate : neighbours_of(families, start_of(families, 2))) {
        const Fit fit = fit_plan(task, plan_of(task, families, candidate), bytes_of, 0);
        REQUIRE(fit.fits);
        CHECK(fit.bytes <= 500'000);
        CHECK(fit.bytes >= 490'000);
    }
    Task by_hand = task;
    by_hand.by_hand.origins = 300;
    const Fit fit = fit_plan(by_hand, start_plan(by_hand, 2), bytes_of, 0);
    CHECK(fit.plan.layout == Layout::chord);
    CHECK(fit.plan.chord.origins == 300);
    CHECK(fit.bytes >= 490'000);
}

}  // namespace lumi::planner
