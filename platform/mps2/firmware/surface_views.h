// SPDX-License-Identifier: MIT
// The views of the frame list's surface part: those of views.h, where clipping, depth and near edges are hardest, and
// some by chance.
#pragma once

#include "lumi/surface/frame.h"
#include "views.h"

namespace lumi::firmware
{

// Rounding takes an eye no farther than this inside the sphere or beyond the end.
inline constexpr int32_t kRounding = 64;
inline constexpr View kHardViews[] = {
    {"on-vertex", 0, 0, kOneQ20 + kRounding, kMaxFovTurns32, 0, 0},
    {"on-sphere", 13 * kTurnHundredth, 4 * kTurnHundredth, kOneQ20 + kRounding, kMaxFovTurns32, 0, 0},
    {"shifted", 55 * kTurnHundredth, -9 * static_cast<int32_t>(kTurnHundredth), radii_q20(130), 80 * kDegree, 20 * 256,
     -36 * 256},
    {"far", 71 * kTurnHundredth, 19 * kTurnHundredth, kMaxEyeDistanceQ20 - kRounding, kMinFovTurns32, 0, 0},
    {"tiny", 5 * kTurnHundredth, 2 * kTurnHundredth, radii_q20(1000), kMaxFovTurns32, 0, 0},
    {"narrow", 42 * kTurnHundredth, 15 * kTurnHundredth, radii_q20(105), kMinFovTurns32, 0, 0},
};

// Looks along the sphere instead of at its centre.
inline Pose aside(const Pose& pose)
{
    return {pose.eye, {-pose.forward.x, -pose.forward.y, -pose.forward.z}, pose.up, pose.right};
}

// A view named "chance" by a number, from 1 to 4 radii.
inline View chance_view(uint32_t number)
{
    uint32_t state = number * 0x9E3779B9;
    const auto next = [&] { return (state = state * 1664525 + 1013904223) >> 8; };
    const uint32_t azimuth = next() << 8;
    const int32_t elevation = static_cast<int32_t>(next() << 7) - kQuarterTurn;
    const int32_t distance = kOneQ20 + kRounding + static_cast<int32_t>(next() % (3 * kOneQ20));
    return {"chance", azimuth, elevation, distance, (2 + next() % 118) * kDegree, 0, 0};
}

}  // namespace lumi::firmware
