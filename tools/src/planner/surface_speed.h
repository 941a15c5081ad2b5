// SPDX-License-Identifier: MIT
// How fast parts draw a surface field: a model over what a view shows, of instructions that `lumi bench` counted.
#pragma once

#include <string>
#include <vector>

#include "bench/chips.h"
#include "planner/surface_load.h"

namespace lumi::planner
{

// Of a frame in RGB565 with the code of `core` ("m0plus", else M4 code). Within about 6 % of the counts, in one view 15
// %.
double surface_instructions(const std::string& core, SurfaceMode mode, const SurfaceLoad& load);

// Flash lines of so many bytes that a frame misses, about.
double surface_misses(const SurfaceLoad& load, double line_bytes);

// Frames of 240 × 240 pixels a second by one core, over poses all around the sphere.
struct PartRate {
    const bench::Chip* chip;
    double mean, worst;
};
std::vector<PartRate> surface_rates(const SurfaceField& field, SurfaceMode mode);

inline constexpr int kRatedPoses = 200;

}  // namespace lumi::planner
