// SPDX-License-Identifier: MIT
// What the simulator was asked for.
#pragma once

#include <string>

namespace simulator
{

struct Options {
    std::string folder;          // where frame-0.bmp, frame-1.bmp, ... go; empty: a window alone
    bool window = true;          // false: the frames of view_of_frame, then the end
    int drag_x = 0, drag_y = 0;  // pixels that the mouse drags after the first frame; then the end. 0, 0: by hand
    bool is_round = false;       // the panel is a disc: what lies outside of it is not seen
    double rate = 0;             // frames a second at most; 0: as fast as this machine
};

extern Options options;

}  // namespace simulator
