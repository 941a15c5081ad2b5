// SPDX-License-Identifier: MIT
// Counts executed instructions under QEMU with `-icount shift=0`: there every instruction takes one virtual nanosecond,
// and SysTick, at 25 MHz on these boards and 20 MHz on that of Cortex-M33, ticks once in kInstructionsPerTick of them.
// The interrupt carries the counter's 24 bits on, so counts do not wrap. Without -icount the numbers mean nothing.
#pragma once

#include <cstdint>

namespace lumi::mps2
{

#ifdef __ARM_ARCH_8M_MAIN__
inline constexpr uint32_t kInstructionsPerTick = 50;
#else
inline constexpr uint32_t kInstructionsPerTick = 40;
#endif

// Starts SysTick; call once before the first reading.
void start_instruction_counter();

// Instructions since the start, rounded down to a whole tick; the caller subtracts two readings.
uint64_t instructions();

}  // namespace lumi::mps2
