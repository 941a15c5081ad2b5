// SPDX-License-Identifier: MIT
// What is wrong with a call, in words that say what the option takes.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace lumi::tools
{

// CLI11's own text, but for numbers, of which it says only that they could not be converted.
std::string parse_problem(const CLI::ParseError& error);

// A check of options: CLI11 takes -1 for the largest number of an unsigned one. Empty if all is well.
std::string whole_number(const std::string& word);

}  // namespace lumi::tools
