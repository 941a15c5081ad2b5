// SPDX-License-Identifier: MIT
// Makes a plan as large as the flash allows: what a plan leaves open, its size, comes from the bytes that remain.
#pragma once

#include "planner/space.h"

namespace lumi::planner
{

// Bytes of the file that a plan bakes into. Throws BakeError for what cannot be baked.
using BytesOf = std::function<uint64_t(const Plan&)>;

struct Fit {
    bool fits = false;
    Plan plan;
    uint64_t bytes = 0;  // of the plan; or, if it does not fit, of its smallest size. 0: unknown
    std::string note;    // why it does not fit
};

// The most origins and directions whose file takes at most task.budget_bytes.
// `slack` > 0: any that takes at least 1 - slack of it will do, which spares most calls of bytes_of. Sizes that were
// set by hand stay.
Fit fit_plan(const Task& task, const Plan& plan, const BytesOf& bytes_of, double slack);

}  // namespace lumi::planner
