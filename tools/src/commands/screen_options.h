// SPDX-License-Identifier: MIT
// --screen and --rows: what a device shows a field on.
#pragma once

#include <CLI/CLI.hpp>

#include "lumi/host/view_memory.h"

namespace lumi::tools
{

// Adds both; `screen` must outlive the parse.
void add_screen_options(CLI::App& command, host::ScreenSize& screen);

}  // namespace lumi::tools
