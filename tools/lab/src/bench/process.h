// SPDX-License-Identifier: MIT
// Runs the compilers and emulators that the bench needs.
#pragma once

#include <string>
#include <vector>

namespace lumi::bench
{

// Runs `command[0]`, found along PATH, and returns what it wrote to standard output and standard error. Throws
// tools::Failure, with the end of that text, unless it ends with 0.
std::string run_program(const std::vector<std::string>& command);

}  // namespace lumi::bench
