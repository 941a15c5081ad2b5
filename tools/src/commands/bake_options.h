// SPDX-License-Identifier: MIT
// The options of `lumi bake`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "../planner/speed.h"
#include "commands/scene_options.h"
#include "lumi/baker/chord.h"
#include "lumi/baker/surface.h"

namespace lumi::tools
{

enum class Layout { automatic, surface, chord };
enum class ProgressStyle { automatic, json };

inline constexpr const char* kUnplannedChord = "a chord field is planned for a size, not for a rate";

// The options that let a planner choose the rest.
struct FitOptions {
    std::string budget, ram, json;
    std::vector<planner::Pace> paces;
    bool plan_only = false;

    bool wanted() const { return !budget.empty(); }
    bool has_rate() const;  // in --for
    // Throws UsageError for a text that is no size. Precondition: wanted().
    uint64_t budget_bytes() const;
    // Does the same for --ram. Precondition: it is given.
    uint64_t ram_bytes() const;
};

struct BakeOptions {
    BakeOptions();

    SceneOptions scene;
    Layout layout = Layout::automatic;
    baker::SurfaceSettings surface;
    baker::SurfaceLimits limits;
    baker::BakeSettings chord;  // by default a byte a texel, which fits devices best
    bool has_origins = false, has_directions = false;
    FitOptions fit;
    host::ScreenSize screen;
    bool has_screen = false;
    std::string output, cap, shard;
    bool restart = false, verbose = false;
    ProgressStyle progress = ProgressStyle::automatic;

    // Whether a surface field is planned for a frame rate.
    bool is_paced() const;
    // The option for which a rate that is asked for is not planned for; null if none is in the way.
    const char* in_the_way_of_rate() const;
};

// Adds them; `options` must outlive the parse.
void add_bake_options(CLI::App& command, BakeOptions& options);

// Completes the options by each other: the layout, and the settings of both layouts. Throws UsageError
// for options that cannot be meant, before the scene is loaded; announces the file of the plan.
void resolve(const CLI::App& command, BakeOptions& options);

}  // namespace lumi::tools
