// SPDX-License-Identifier: MIT
// What a planner has found, for people and for programs.
#pragma once

#include "planner/planner.h"

namespace lumi::planner
{

// What was chosen and how to set it by hand, what was tried instead and what that costs, what half and twice the flash
// would show.
std::string text_of(const Result& result);
std::string json_of(const Result& result);

// One line a trial.
std::string text_of(const PlanProgress& progress);
// {"best_psnr_db":30.1,"elapsed_seconds":12.0,"eta_seconds":40.0,"state":"planning","trials_done":4,"trials_left":13}
std::string json_of(const PlanProgress& progress);

}  // namespace lumi::planner
