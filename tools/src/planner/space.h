// SPDX-License-Identifier: MIT
// The plans that a search may choose from, for a scene, a flash budget and what the user has decided already.
#pragma once

#include <optional>

#include "planner/plan.h"
#include "planner/plan_search.h"
#include "quality/held_out.h"

namespace lumi::planner
{

// What was set by hand stays as it is.
struct ByHand {
    std::optional<uint32_t> origins, directions;
    std::optional<format::TexelFormat> texel;
    std::function<uint32_t(uint32_t origins)> cap;  // used origins of so many; empty: not set
};

// What a field is planned for.
struct Task {
    uint64_t budget_bytes = 0;
    quality::ViewSet views = quality::ViewSet::all;
    ByHand by_hand;
    // Of the final bake.
    uint32_t samples = 16;
    float max_error_levels = 1;
    uint64_t seed = 1;
    unsigned threads = 0;
};

// One family, of chord fields; its start is what measured well.
std::vector<Family> families_of(const Task& task);

// The plan of a candidate, but for its size: origins and directions in proportion to each other are what fit_plan()
// makes of the budget.
Plan plan_of(const Task& task, const std::vector<Family>& families, const Candidate& candidate);

}  // namespace lumi::planner
