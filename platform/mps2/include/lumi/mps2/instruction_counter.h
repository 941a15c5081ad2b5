// SPDX-License-Identifier: MIT
// Counts executed instructions under QEMU with `-icount shift=0`: there every instruction takes one virtual nanosecond,
// and SysTick ticks once in 1000 / LUMI_MPS2_CLOCK_MHZ of them, 31 to 50 (boards.cmake). The interrupt carries the
// counter's 24 bits on, so counts do not wrap. Without -icount the numbers mean nothing.
#pragma once

#include <cstdint>

namespace lumi::mps2
{

// 31.25 at the 32 MHz of AN547.
inline constexpr uint32_t kInstructionsPer4Ticks = 4000 / LUMI_MPS2_CLOCK_MHZ;
static_assert(kInstructionsPer4Ticks * LUMI_MPS2_CLOCK_MHZ == 4000, "a tick takes whole quarters of an instruction");

// Starts SysTick; call once before the first reading.
void start_instruction_counter();

// Instructions since the start, rounded down to a whole tick; the caller subtracts two readings.
uint64_t instructions();

}  // namespace lumi::mps2
