// SPDX-License-Identifier: MIT
#include "commands/fit_options.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "../planner/plan_report.h"
#include "commands/choice.h"
#include "files/output_file.h"
#include "terminal/failure.h"
#include "terminal/interrupt.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

using planner::ByHand;

std::function<uint32_t(uint32_t)> cap_by_hand(const std::string& cap)
{
    if (cap.empty()) return {};
    return [cap](uint32_t origins) {
        const auto used = parse_cap(cap, origins);
        if (!used) throw baker::BakeError("--cap " + cap + " is no part of " + std::to_string(origins) + " origins");
        return *used;
    };
}

ByHand by_hand(const FitContext& context)
{
    ByHand set;
    const auto take = [&](const char* option, auto& value, const auto& given) {
        if (context.command.count(option) > 0) value = given;
    };
    take("--origins", set.origins, context.common.origins);
    take("--directions", set.directions, context.common.directions);
    take("--texel", set.texel, context.common.texel);
    set.cap = cap_by_hand(context.cap);
    return set;
}

planner::Task task_of(const FitOptions& options, const FitContext& context)
{
    planner::Task task;
    task.budget_bytes = options.budget_bytes();
    task.views = options.views;
    task.by_hand = by_hand(context);
    task.samples = context.common.samples;
    task.max_error_levels = context.common.max_error_levels;
    task.seed = context.common.seed;
    task.threads = context.common.threads;
    return task;
}

planner::PlanSettings settings_of(const FitOptions& options)
{
    planner::PlanSettings settings;
    settings.measure.samples = planner::trial_samples(options.budget_bytes());
    settings.measure.views = options.view_count;
    settings.measure.cache = options.cache;
    settings.search.max_trials = options.max_trials;
    settings.outlook = options.max_trials > 1;  // who asks for one trial asks what one plan is worth
    settings.measure.pace = options.wanted_pace();
    return settings;
}

void print_line(std::FILE* stream, const std::string& line)
{
    std::fprintf(stream, "%s\n", line.c_str());
    std::fflush(stream);
}

}  // namespace

uint64_t FitOptions::budget_bytes() const
{
    const auto bytes = parse_bytes(budget);
    if (!bytes || *bytes == 0 || *bytes > UINT32_MAX)
        throw UsageError("--fit takes a size below 4 GB such as 2MB, 512KiB or 1500000, not \"" + budget + "\"");
    return *bytes;
}

std::optional<planner::Pace> FitOptions::wanted_pace() const
{
    if (pace.empty()) return std::nullopt;
    if (const auto parsed = planner::parse_pace(pace)) return parsed;
    throw UsageError("--for takes a part and a frame rate such as rp2040@30fps, with " + planner::chip_names() +
                     ", not \"" + pace + "\"");
}

void add_fit_options(CLI::App& command, FitOptions& options)
{
    command
        .add_option(
            "--fit", options.budget,
            "Choose all parameters that are not set by hand so that the file takes at most this: 2MB, 512KiB, 1500000")
        ->type_name("SIZE");
    command.add_option("--for", options.pace, "fit: draw on this part at this rate: " + planner::chip_names())
        ->type_name("PART@RATEfps");
    add_choice<quality::ViewSet>(
        command, "--views", options.views,
        {{"all", quality::ViewSet::all}, {"upper", quality::ViewSet::upper}, {"ring", quality::ViewSet::ring}}, "SET",
        "fit, chord: the views that must be good: all around, upper half, or ring [all]");
    command.add_option("--count", options.view_count, "fit, chord: number of views to measure from")
        ->type_name("COUNT")
        ->check(CLI::Range(1u, 100u))
        ->capture_default_str();
    command.add_option("--trials", options.max_trials, "fit, chord: trial bakes at most")
        ->type_name("COUNT")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_flag("--plan-only", options.plan_only, "fit: end with the plan, without a bake");
    command.add_option("--plan", options.json, "fit: write the plan, and all that was measured, here as JSON")
        ->type_name("FILE");
    command.add_option("--cache", options.cache, "fit, chord: folder that keeps references, as of lumi report [none]")
        ->type_name("DIR");
}

void check_fit(const FitOptions& options, const FitContext& context, Layout layout)
{
    if (!options.wanted()) {
        for (const char* name : {"--for", "--views", "--count", "--trials", "--plan-only", "--plan", "--cache"})
            if (context.command.count(name) > 0) throw UsageError(std::string(name) + " belongs to --fit");
        return;
    }
    if (context.command.count("--shard") > 0)
        throw UsageError("--shard does not go with --fit; shard the plan it finds");
    settings_of(options);
    if (layout == Layout::chord) task_of(options, context);
    announce_outputs({options.json});
}

void write_plan(const FitOptions& options, const planner::SurfaceTask& task, const planner::SurfacePlan& plan)
{
    if (options.json.empty()) return;
    const nlohmann::json json = {
        {"budget_bytes", task.budget_bytes},    {"layout", "surface"},
        {"options", options_of(plan)},          {"most_bytes", plan.most_bytes},
        {"triangles", plan.draft->triangles()}, {"texels_per_radius", plan.settings.texels_per_radius},
        {"missed", plan.draft->loss().missed}};
    write_output(options.json, json.dump(2) + "\n");
}

planner::Plan fitted_plan(const FitOptions& options, const FitContext& context, const baker::Scene& scene)
{
    const planner::Task task = task_of(options, context);
    const baker::ProgressCallback interrupted = [](const baker::Progress&) {
        return !interrupt_flag().load(std::memory_order_relaxed);
    };
    const auto report = [&](const planner::PlanProgress& at) {
        context.json_progress ? print_line(stdout, json_of(at)) : print_line(stderr, text_of(at));
    };
    try {
        if (!context.json_progress) print_line(stderr, "tracing references to measure against");
        planner::Result result = planner::plan_field(scene, task, settings_of(options), interrupted, report);
        result.best.plan = planner::final_plan(result);
        if (!options.json.empty()) write_output(options.json, json_of(result));
        if (!context.json_progress) std::fputs(text_of(result).c_str(), stdout);
        std::fflush(stdout);
        return result.best.plan;
    } catch (const planner::NoPlan& none) {
        throw Failure("--fit " + options.budget, none.what(), "give more flash, or set less by hand");
    } catch (const baker::Cancelled&) {
        throw Interrupted();
    }
}

}  // namespace lumi::tools
