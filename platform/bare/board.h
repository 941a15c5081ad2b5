// SPDX-License-Identifier: MIT
// The examples ask this of a board. Each has a board.cpp of its own: the part that another product replaces.
#pragma once

#include <lumi/orbit.h>
#include <stdint.h>

namespace board
{

// The view of the next frame; false: there is none. What was sent before is on the display when it returns.
bool next_view(lumi::Orbit& orbit);

// Sends pixels to the display, in its own format and order. May return before they are sent; then it waits for those of
// the call before, so two stripes in turn are enough.
void send(const uint8_t* pixels, uint32_t bytes);

// The frames that every example draws, where nobody turns the object: tools/lab/devices.sh compares their pictures.
constexpr int kFrames = 2;
inline lumi::Orbit view_of_frame(int frame)
{
    return {lumi::degrees(30 + 300 * frame), lumi::degrees(20 + 15 * frame), lumi::radii(3)};
}

}  // namespace board
