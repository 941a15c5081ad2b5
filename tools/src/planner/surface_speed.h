// SPDX-License-Identifier: MIT
// How fast parts draw a surface field: a model of instructions, fitted to what boards executed
// (docs/log/tradeoff.md).
#pragma once

#include <string>
#include <vector>

#include "lumi/host/view_memory.h"
#include "planner/chips.h"
#include "planner/surface_work.h"

namespace lumi::planner
{

// Instructions of a frame in RGB565 with the code of `core` ("m0plus", "m4" or "m7").
double surface_instructions(const std::string& core, SurfaceMode mode, const SurfaceWork& work);

// Flash lines of so many bytes that a frame misses, about.
double surface_misses(const SeeThroughField& field, const SurfaceWork& work, double line_bytes);

// Frames a second by one core, over poses all around the sphere.
struct PartRate {
    const Chip* chip;
    double mean, worst;
    double instructions;  // a frame, in the mean
};
std::vector<PartRate> surface_rates(const SeeThroughField& field, SurfaceMode mode,
                                    const host::ScreenSize& screen = {});

inline constexpr int kRatedPoses = 200;

// From how many poses such a screen is rated: kRatedPoses up to 480 × 480 pixels; of larger ones fewer, since each pose
// is drawn.
int rated_poses(const host::ScreenSize& screen);

}  // namespace lumi::planner
