// SPDX-License-Identifier: MIT
// The simulator keeps here what it was asked for.
#pragma once

#include <string>

namespace simulator
{

struct Options {
    std::string folder;          // where frame-0.png, frame-1.png, ... go; empty: a window alone
    bool window = true;          // false: the frames of view_of_frame, then the end
    int drag_x = 0, drag_y = 0;  // pixels that the mouse drags after the first frame; then the end. 0, 0: by hand
    int width_px = 240, height_px = 240;
    bool is_round = false;          // the panel is a disc: what lies outside of it is not seen
    int (*sized_main)() = nullptr;  // of --size, in place of the Pico's main()
    double rate = 0;                // frames a second at most; 0: as fast as this machine
};

extern Options options;

}  // namespace simulator
