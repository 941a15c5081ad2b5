// SPDX-License-Identifier: MIT
// The plans that a search may choose from, for a scene, a flash budget and what the user has decided already.
#pragma once

#include <optional>

#include "planner/plan.h"
#include "planner/plan_search.h"
#include "quality/held_out.h"

namespace lumi::planner
{

// What was set by hand stays as it is. A layout that has no use for one of these is out of the search.
struct ByHand {
    std::optional<Layout> layout;
    std::optional<uint32_t> origins, chart_size, triangles, mean_resolution, directions;
    std::optional<format::MeanFormat> mean_format;
    std::optional<format::GuidedTexel> texel;
    std::optional<bool> occlusion;
    std::optional<format::TexelFormat> chord_texel;
    std::optional<float> focus_radius;              // scene units
    std::optional<std::array<float, 3>> focus;      // scene units and axes
    std::optional<float> jitter;                    // of guided layouts
    std::function<uint32_t(uint32_t origins)> cap;  // used origins of so many; empty: not set
};

// What a field is planned for.
struct Task {
    uint64_t budget_bytes = 0;
    quality::ViewSet views = quality::ViewSet::all;
    ByHand by_hand;
    float radius = 1;  // of the scene's sphere, in scene units
    // Of the final bake.
    uint32_t samples = 16;
    float max_error_levels = 1;
    uint64_t seed = 1;
    unsigned threads = 0;
};

// Which layouts a task leaves, guided before focus before chord.
std::vector<Layout> layouts_of(const ByHand& by_hand);

// A family for each of them; its start is what measured well at such a budget.
std::vector<Family> families_of(const Task& task);

// The plan of a candidate, but for its size: chart_size, or origins and directions of a chord field in proportion to
// each other, are what fit_plan() makes of the budget.
Plan plan_of(const Task& task, const std::vector<Family>& families, const Candidate& candidate);

}  // namespace lumi::planner
