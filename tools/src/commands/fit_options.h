// SPDX-License-Identifier: MIT
// The options of `lumi bake` that let a planner choose the rest.
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "../planner/chord_plan.h"
#include "../planner/speed.h"
#include "../planner/surface_plan.h"

namespace lumi::tools
{

struct FitOptions {
    std::string budget, ram, json;
    std::vector<planner::Pace> paces;
    bool plan_only = false;

    bool wanted() const { return !budget.empty(); }
    // Throws UsageError for a text that is no size. Precondition: wanted().
    uint64_t budget_bytes() const;
    // The same for --ram. Precondition: it is given.
    uint64_t ram_bytes() const;
};

// Adds --fit and what goes with it; `options` must outlive the parse.
void add_fit_options(CLI::App& command, FitOptions& options);

// What `lumi bake` was told besides.
struct FitContext {
    const CLI::App& command;
    const baker::BakeSettings& common;  // samples, seed, threads, origins, directions, texel
    const std::string& cap;
    bool json_progress;
    const host::ScreenSize& screen;
};

// Throws UsageError for options that cannot be meant: before the scene is loaded.
void check_fit(const FitOptions& options, const FitContext& context);

// Writes the plan of a surface field where the options ask for it.
void write_plan(const FitOptions& options, const planner::SurfaceTask& task, const planner::SurfacePlan& plan);

// Throws Failure where no chord field fits.
void require_chord_fit(const FitOptions& options, const FitContext& context);

// Plans a chord field and tells what was found. Throws Failure where nothing fits.
baker::BakeSettings fitted_chord(const FitOptions& options, const FitContext& context);

}  // namespace lumi::tools
