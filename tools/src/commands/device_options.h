// SPDX-License-Identifier: MIT
// The options that say on which devices a field is drawn.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "../planner/speed.h"
#include "lumi/host/view_memory.h"

namespace lumi::tools
{

// Adds "--for LIST", a list of PART or PART@RATEfps: which parts draw, and how many frames a second they should reach.
// `paces` must outlive the parse. Another word is refused.
void add_pace_option(CLI::App& command, std::vector<planner::Pace>& paces, const std::string& description);

// Adds --screen and --rows, what a device shows a field on; `screen` must outlive the parse.
void add_screen_options(CLI::App& command, host::ScreenSize& screen);

}  // namespace lumi::tools
