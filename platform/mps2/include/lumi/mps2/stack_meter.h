// SPDX-License-Identifier: MIT
// Measures how deep the stack gets: paints the memory below the stack pointer, and looks afterwards for the lowest word
// that lost its paint. Interrupts that come in between count too (SysTick: 32 bytes).
#pragma once

#include <cstdint>

namespace lumi::mps2
{

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
