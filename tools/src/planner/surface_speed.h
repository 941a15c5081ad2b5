// SPDX-License-Identifier: MIT
// How fast parts draw a surface field: a model over what a view shows, of instructions that `lumi-lab bench` counted.
#pragma once

#include <string>
#include <vector>

#include "lumi/host/view_memory.h"
#include "planner/chips.h"
#include "planner/surface_load.h"

namespace lumi::planner
{

// Instructions of a frame in RGB565 with the code of `core` ("m0plus", else M4 code). Fitted to 840 counts of
// desk clocks of 30, 90 and 250 kB and test cards of 40 and 150 kB, 240 and 466 pixels a side, in stripes of 2 to 32
// rows: within 10 % of 585 of them, 30 % in the worst; 9 % in the root mean square.
// What the image cuts is unknown to the model: nearer than two radii counts are higher. What see-through triangles add
// was fitted to 48 counts of four fields in stripes of 16 rows, without halvings: then within 18 % of the frame.
double surface_instructions(const std::string& core, SurfaceMode mode, const SurfaceLoad& load);

// Flash lines of so many bytes that a frame misses, about.
double surface_misses(const SurfaceLoad& load, double line_bytes);

// Frames a second by one core, over poses all around the sphere.
struct PartRate {
    const Chip* chip;
    double mean, worst;
    double instructions;  // a frame, in the mean
};
std::vector<PartRate> surface_rates(const SeeThroughField& field, SurfaceMode mode,
                                    const host::ScreenSize& screen = {});

inline constexpr int kRatedPoses = 200;

}  // namespace lumi::planner
