// SPDX-License-Identifier: MIT
// Start-up of the examples without an SDK: memory as the linker script (sections.ld) lays it out, then main().
#pragma once

#include <stdint.h>

// Called by the board's reset with a stack. Copies initial values and the code that runs in RAM, clears .bss, paints
// the free stack, calls constructors and main, and ends in board_stop.
extern "C" [[noreturn]] void lumi_start();

// The board's own: the end of a program, with main's result.
extern "C" [[noreturn]] void board_stop(int code);

// How far the stack has been used since the start, from painted memory.
uint32_t used_stack_bytes();
