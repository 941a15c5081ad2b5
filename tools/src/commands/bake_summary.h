// SPDX-License-Identifier: MIT
// What `lumi bake` says: what it chose, how far it is, what it wrote and what that is worth.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "../planner/speed.h"
#include "commands/bake_job.h"
#include "commands/surface_choice.h"
#include "lumi/host/view_memory.h"

namespace lumi::tools
{

enum class BakeStep { planning, baking, measuring };

// What progress begins with in a bake of so many steps: "2 of 3 baking: "; nothing where there is one.
std::string step_text(BakeStep step, int steps);

struct BakeSummary {
    using Clock = std::chrono::steady_clock;

    const baker::Scene& scene;
    const BakeJob& job;
    size_t warnings;
    Clock::time_point start;
    const std::vector<planner::Pace>& paces;  // that the field should be drawn at
    std::optional<host::ScreenSize> screen;   // that was asked for
    bool checks;  // whether it was planned by its mesh, and is judged by a few path-traced views

    int steps() const { return !checks ? 1 : job.shard ? 2 : 3; }
};

// The layout, its reason and its figures, before the bake; what a surface will not show goes to stderr. Returns how
// many warnings that were.
size_t tell_choice(const SurfaceChoice& choice, const planner::SurfaceTask& task, bool takes_surface, bool json);

// Both bake. For people: a bar or lines on stderr, a summary on stdout.
void bake_for_people(const BakeSummary& summary);
// For machines: nothing but JSON lines on stdout.
void bake_for_machines(const BakeSummary& summary);

}  // namespace lumi::tools
