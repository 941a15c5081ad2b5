// SPDX-License-Identifier: MIT
#include "commands/fit_options.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "../planner/no_plan.h"
#include "commands/pace_option.h"
#include "files/output_file.h"
#include "terminal/failure.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

// Of the option `name`, whose text is `text`.
uint64_t size_of(const std::string& name, const std::string& text, const std::string& examples)
{
    const auto bytes = parse_bytes(text);
    if (!bytes || *bytes == 0 || *bytes > UINT32_MAX)
        throw UsageError(name + " takes a size below 4 GB such as " + examples + ", not \"" + text + "\"");
    return *bytes;
}

// A chord field needs a stripe and little more, whatever its size.
void require_chord_ram(const FitOptions& options, const FitContext& context)
{
    if (options.ram.empty()) return;
    const uint64_t needed =
        host::chord_view_bytes(true) + uint64_t{host::stripe_pixel_bytes<PixelRgb565>(context.screen)};
    if (needed > options.ram_bytes())
        throw Failure("--ram " + options.ram,
                      "a view and a stripe of " + std::to_string(context.screen.stripe_rows()) + " rows take " +
                          std::to_string(needed) + " bytes",
                      "give more RAM, or fewer --rows");
}

planner::ChordTask task_of(const FitOptions& options, const FitContext& context)
{
    planner::ChordTask task;
    task.budget_bytes = options.budget_bytes();
    task.settings = context.common;
    task.origins_by_hand = context.command.count("--origins") > 0;
    task.directions_by_hand = context.command.count("--directions") > 0;
    if (context.cap.empty()) return task;
    task.cap = [cap = context.cap](uint32_t origins) {
        const auto used = parse_cap(cap, origins);
        if (!used) throw baker::BakeError("--cap " + cap + " is no part of " + std::to_string(origins) + " origins");
        return *used;
    };
    return task;
}

baker::BakeSettings planned(const FitOptions& options, const FitContext& context)
{
    require_chord_ram(options, context);
    try {
        return planner::plan_chord(task_of(options, context));
    } catch (const planner::NoPlan& none) {
        throw Failure("--fit " + options.budget, none.what(), "give more flash, or set less by hand");
    }
}

}  // namespace

uint64_t FitOptions::budget_bytes() const
{
    return size_of("--fit", budget, "2MB, 512KiB or 1500000");
}

uint64_t FitOptions::ram_bytes() const
{
    return size_of("--ram", ram, "40kB, 64KiB or 20000");
}

void add_fit_options(CLI::App& command, FitOptions& options)
{
    command
        .add_option(
            "--fit", options.budget,
            "Choose all parameters that are not set by hand so that the file takes at most this: 2MB, 512KiB, 1500000")
        ->type_name("SIZE");
    command
        .add_option("--ram", options.ram,
                    "fit: a mesh so coarse that view and stripe take at most so much RAM, antialiased on --screen: "
                    "40kB")
        ->type_name("SIZE");
    add_pace_option(command, options.paces, "fit: say by which mode these parts draw the field at that rate");
    command.add_flag("--plan-only", options.plan_only, "fit: end with the plan, without a bake");
    command.add_option("--plan", options.json, "fit: write the plan here as JSON")->type_name("FILE");
}

void check_fit(const FitOptions& options, const FitContext& context)
{
    if (!options.wanted()) {
        for (const char* name : {"--for", "--ram", "--plan-only", "--plan"})
            if (context.command.count(name) > 0) throw UsageError(std::string(name) + " belongs to --fit");
        return;
    }
    if (context.command.count("--shard") > 0)
        throw UsageError("--shard does not go with --fit; shard the plan it finds");
    options.budget_bytes();
    if (!options.ram.empty()) options.ram_bytes();
    announce_outputs({options.json});
}

void write_plan(const FitOptions& options, const planner::SurfaceTask& task, const planner::SurfacePlan& plan)
{
    if (options.json.empty()) return;
    nlohmann::json json = {
        {"budget_bytes", task.budget_bytes},    {"layout", "surface"},
        {"options", options_of(plan)},          {"most_bytes", plan.most_bytes},
        {"triangles", plan.draft->triangles()}, {"texels_per_radius", plan.settings.texels_per_radius},
        {"missed", plan.draft->loss().missed}};
    if (task.ram) json.update({{"ram_bytes", plan.ram_bytes}, {"triangles_without_ram", plan.triangles_without_ram}});
    write_output(options.json, json.dump(2) + "\n");
}

void require_chord_fit(const FitOptions& options, const FitContext& context)
{
    planned(options, context);
}

baker::BakeSettings fitted_chord(const FitOptions& options, const FitContext& context)
{
    const baker::BakeSettings plan = planned(options, context);
    nlohmann::json json = {{"layout", "chord"}, {"options", planner::options_of(plan)}};
    if (context.json_progress) {
        json["state"] = "planned";
        std::printf("%s\n", json.dump().c_str());
    } else {
        std::printf("layout chord: %s\n  by hand: %s\n", planner::text_of(plan).c_str(),
                    planner::options_of(plan).c_str());
    }
    std::fflush(stdout);
    if (options.json.empty()) return plan;
    json.erase("state");
    json["budget_bytes"] = options.budget_bytes();
    json["bytes"] = baker::field_file_bytes(plan);
    write_output(options.json, json.dump(2) + "\n");
    return plan;
}

}  // namespace lumi::tools
