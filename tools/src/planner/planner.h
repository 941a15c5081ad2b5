// SPDX-License-Identifier: MIT
// From a scene and a flash budget to the plan of the best field: space.h says what may be chosen, trials.h what it is
// worth, search.h what to try next.
#pragma once

#include "planner/no_plan.h"
#include "planner/trials.h"

namespace lumi::planner
{

// A plan that was measured, by what distinguishes it.
struct Alternative {
    std::string what;  // "texel rgb565"
    Measurement measurement;
    double difference_db = 0;  // to the best
};

struct Result {
    Task task;
    MeasureSettings settings;
    Measurement best;
    std::vector<Measurement> tried;          // in order, the best among them
    std::vector<Alternative> alternatives;   // one step away from the best
    bool exhausted = false;                  // the search ended because its trials were spent
    std::optional<Measurement> half, twice;  // the best measured with half and with twice the flash
    double seconds = 0;
};

struct PlanProgress {
    size_t done = 0, left = 0;  // trials; `left` at least
    double elapsed_seconds = 0, eta_seconds = -1;
    const Measurement* last = nullptr;
    const Measurement* best = nullptr;
};
using PlanReport = std::function<void(const PlanProgress&)>;

struct PlanSettings {
    MeasureSettings measure;
    SearchSettings search;
    bool outlook = true;  // also measure half and twice the flash
};

// `progress` is asked during bakes and cancels them; `report` is told after every trial. Throws NoPlan, Cancelled.
Result plan_field(const baker::Scene& scene, const Task& task, const PlanSettings& settings,
                  const baker::ProgressCallback& progress, const PlanReport& report);

// The plan with the size that uses the budget to the byte, for the final bake.
Plan final_plan(const Result& result);

}  // namespace lumi::planner
