// SPDX-License-Identifier: MIT
// From reset to main: the vector table's stack pointer and reset handler, .data, .bss, constructors, main, exit.
// A fault prints a line and ends the program with kFaultExitCode, so that a broken test fails and does not hang.
#pragma once

namespace lumi::mps2
{

inline constexpr int kFaultExitCode = 70;

// Called before the first constructor; the default does nothing. A program that uses newlib's files opens them here.
extern "C" void lumi_before_constructors();

}  // namespace lumi::mps2
