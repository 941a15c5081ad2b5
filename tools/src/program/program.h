// SPDX-License-Identifier: MIT
// How our programs run: they parse, tell problems in one voice, and end with a code of terminal/failure.h.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace lumi::tools
{

// `describe` adds texts and subcommands; these do their work while the command line is parsed.
int run_program(const char* name, const std::function<void(CLI::App&)>& describe, int argc, char** argv);

}  // namespace lumi::tools
