// SPDX-License-Identifier: MIT
// Turns an object by a finger or a mouse: it follows, and runs on when it is let go.
//
//     OrbitDrag drag({degrees(180) / 240});                     // half a turn across the display
//     const bool is_moving = drag.next(touch, elapsed_ms, orbit);    // each frame; for QualityControl
#pragma once
#pragma GCC system_header

#include "lumi/orbit.h"

namespace lumi
{

struct Touch {
    bool is_down;
    int32_t x_px, y_px;  // to the right and down, -32768 .. 32767; where it was last, if it is up
};

struct DragSettings {
    uint32_t turns32_per_px;      // below 1/16 turn
    uint32_t half_life_ms = 250;  // how long an object that runs on takes to halve its speed; 0: it stops at once
    uint32_t elevation_limit = degrees(85);  // the elevation stays between -limit and limit; up to 1/4 turn
};

// Frames may be of any length: the way that an object runs on does not depend on it but for a few percent.
class OrbitDrag
{
public:
    constexpr explicit OrbitDrag(const DragSettings& settings) : settings_(settings) {}

    // Changes the orbit's angles; whether it moves. `elapsed_ms` since the last call, 1 .. 1000 (less or more counts as
    // that).
    bool next(const Touch& touch, uint32_t elapsed_ms, Orbit& orbit);

private:
    void follow(int32_t x_px, int32_t y_px, int32_t elapsed_ms, Orbit& orbit);
    void run_on(int32_t elapsed_ms, Orbit& orbit);
    void turn(int64_t azimuth, int64_t elevation, Orbit& orbit) const;

    DragSettings settings_;
    bool was_down_ = false;
    int32_t x_px_ = 0, y_px_ = 0;
    int64_t azimuth_speed_ = 0, elevation_speed_ = 0;  // turns32 a millisecond
};

}  // namespace lumi
