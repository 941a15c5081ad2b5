// SPDX-License-Identifier: MIT
// Meters of a program on an emulated board: instructions, and depth of the stack.
//
// Instructions are counted under QEMU with `-icount shift=0`: there every instruction takes one virtual nanosecond, and
// SysTick ticks once in 1000 / LUMI_MPS2_CLOCK_MHZ of them, 31 to 50 (boards.cmake). The interrupt carries the
// counter's 24 bits on, so counts do not wrap. Without -icount the numbers mean nothing.
#pragma once

#include <cstdint>

namespace lumi::mps2
{

// This is 31.25 at the 32 MHz of AN547.
inline constexpr uint32_t kInstructionsPer4Ticks = 4000 / LUMI_MPS2_CLOCK_MHZ;
static_assert(kInstructionsPer4Ticks * LUMI_MPS2_CLOCK_MHZ == 4000, "a tick takes whole quarters of an instruction");

// Starts SysTick; call once before the first reading.
void start_instruction_counter();

// Instructions since the start, rounded down to a whole tick; the caller subtracts two readings.
uint64_t instructions();

// Measures how deep the stack gets: paints the memory below the stack pointer, and looks afterwards for the lowest word
// that lost its paint. Interrupts that come in between count too (SysTick: 32 bytes).
class StackMeter
{
public:
    static constexpr uint32_t kPaintedBytes = 16 * 1024;

    // Paints. Measure in a function that was called after the painting, so that only deeper calls count.
    void paint();

    // Bytes below the stack pointer of paint() that have been written since; kPaintedBytes means at least that many.
    uint32_t high_water_bytes() const;

private:
    uint32_t* top_ = nullptr;
};

}  // namespace lumi::mps2
