// SPDX-License-Identifier: MIT
// --for: which parts draw, and how many frames a second they should reach.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "../planner/speed.h"

namespace lumi::tools
{

// Adds "--for LIST", a list of PART or PART@RATEfps; `paces` must outlive the parse. Another word is refused.
void add_pace_option(CLI::App& command, std::vector<planner::Pace>& paces, const std::string& description);

}  // namespace lumi::tools
