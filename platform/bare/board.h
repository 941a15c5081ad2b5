// SPDX-License-Identifier: MIT
// The examples ask this of a board. Each has a board.cpp of its own: the part that another product replaces.
#pragma once

#include <lumi/orbit.h>
#include <lumi/stripe.h>
#include <stdint.h>

namespace board
{

// The view of the next frame; false: there is none. What was sent before is on the display when it returns.
bool next_view(lumi::Orbit& orbit);

// Sends pixels to the display, in its own format and order. May return before they are sent; then it waits for those of
// the call before, so two stripes in turn are enough.
void send(const uint8_t* pixels, uint32_t bytes);

// Only where clocks run. Waits for a new second since midnight, or for a new view, and tells both; false: the program
// ends. Nobody has set a board's clock: it starts at kFirstSecond.
bool next_second(lumi::Orbit& orbit, uint32_t& second);
// The pixels that are sent next are those of this rectangle, row by row.
void set_window(const lumi::PixelRect& window);
constexpr uint32_t kFirstSecond = (10 * 60 + 8) * 60 + 57;

// The frames that every example draws, where nobody turns the object: tools/lab/devices.sh compares their pictures.
constexpr int kFrames = 2;
inline lumi::Orbit view_of_frame(int frame)
{
    return {lumi::degrees(30 + 300 * frame), lumi::degrees(20 + 15 * frame), lumi::radii(3)};
}

}  // namespace board

// Start-up of the examples without an SDK: memory as the linker script (sections.ld) lays it out, then main().
//
// Called by the board's reset with a stack. Copies initial values and the code that runs in RAM, clears .bss, paints
// the free stack, calls constructors and main, and ends in board_stop.
extern "C" [[noreturn]] void lumi_start();

// The board has its own end of a program, with main's result.
extern "C" [[noreturn]] void board_stop(int code);

// How far the stack has been used since the start, from painted memory.
uint32_t used_stack_bytes();
