// SPDX-License-Identifier: MIT
// Checks of what options take; their words say what the option takes.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>

namespace lumi::tools
{

// Checks of an option's word, for CLI::Option::check: empty if all is well, otherwise "takes ..., not ...". The whole
// word is a decimal number, without spaces. CLI11's own ranges let "nan" pass, and its whole numbers wrap or saturate.
using WordCheck = std::function<std::string(const std::string&)>;

WordCheck whole_number(uint64_t least, uint64_t most);
// A finite number.
WordCheck number(double least, double most);
WordCheck any_number();

// The most light paths for a texel or a pixel, and the most threads, that options take.
constexpr uint64_t kMostPaths = uint64_t{1} << 24;
constexpr uint64_t kMostThreads = 1024;

// Adds to every option and argument of `app` and its subcommands that takes words: none is empty or has a control
// character, such as the line break of a file's name that a script cut wrongly. None is "-", which would be the name of
// a file.
void require_plain_words(CLI::App& app);

// CLI11's text, "NAME takes ..." where a check or a choice failed.
std::string parse_problem(const CLI::ParseError& error);

}  // namespace lumi::tools
