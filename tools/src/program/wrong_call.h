// SPDX-License-Identifier: MIT
// These say what a program answers to a call that it does not understand, and print its help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace lumi::tools
{

// Says what is wrong, and for a mistyped command or option which one may be meant.
std::string problem_of(const CLI::App& app, const CLI::ParseError& error);

// Adds `program help` and `program help COMMAND`. Call after all other commands were added.
void add_help_command(CLI::App& app, const std::string& program);

}  // namespace lumi::tools
