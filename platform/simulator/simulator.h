// SPDX-License-Identifier: MIT
// The simulator: what it was asked for, its loops and its window.
#pragma once

#include <lumi/orbit.h>

#include <cstdint>
#include <string>

namespace simulator
{

inline constexpr int kWidthPx = 240, kHeightPx = 240;  // of the display, the Screen of the firmware

struct Options {
    std::string folder;          // where frame-0.png, frame-1.png, ... go; empty: a window alone
    bool window = true;          // false: the frames of view_of_frame, then the end
    int drag_x = 0, drag_y = 0;  // pixels that the mouse drags after the first frame; then the end. 0, 0: by hand
    bool is_round = false;       // the panel is a disc: what lies outside of it is not seen
    double rate = 0;             // frames a second at most; 0: as fast as this machine
};

extern Options options;

// A window that shows a display and turns what it shows by the mouse (window.cpp).
//
// Opens the window; ends the program where it cannot.
void open_window();
// Shows RGB565 in the CPU's order.
void show(const uint16_t* pixels);
// Waits until somebody turns the object, or so many milliseconds, -1 for ever; false: the window was closed.
bool wait_for_turn(lumi::Orbit& orbit, int most_ms = -1);
// Drags the mouse, for tests.
void drag(int x_px, int y_px);
void wait_milliseconds(uint32_t count);
uint32_t milliseconds();

}  // namespace simulator
