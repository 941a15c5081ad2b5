// SPDX-License-Identifier: MIT
// Counts executed instructions under QEMU with `-icount shift=0`: there every instruction takes one virtual nanosecond,
// and SysTick, at 25 MHz on these boards, ticks once in kInstructionsPerTick of them. The interrupt carries the
// counter's 24 bits on, so counts do not wrap. Without -icount the numbers mean nothing.
#pragma once

#include <cstdint>

namespace lumi::mps2
{

inline constexpr uint32_t kInstructionsPerTick = 40;

// Starts SysTick; call once before the first reading.
void start_instruction_counter();

// Instructions since the start, rounded down to a whole tick; the caller subtracts two readings.
uint64_t instructions();

}  // namespace lumi::mps2
