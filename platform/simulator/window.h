// SPDX-License-Identifier: MIT
// A window that shows a display and turns what it shows by the mouse.
#pragma once

#include <lumi/orbit.h>

#include <cstdint>

namespace simulator
{

// Opens a window for the display that options ask for; ends the program where it cannot.
void open_window();
// RGB565 in the CPU's order.
void show(const uint16_t* pixels);
// Waits until somebody turns the object; false: the window was closed.
bool wait_for_turn(lumi::Orbit& orbit);
// Drags the mouse, for tests.
void drag(int x_px, int y_px);
void wait_milliseconds(uint32_t count);
uint32_t milliseconds();

}  // namespace simulator
