// SPDX-License-Identifier: MIT
// How fast parts draw a surface field: a model over what a view shows, of instructions that `lumi-lab bench` counted.
#pragma once

#include <string>
#include <vector>

#include "planner/chips.h"
#include "planner/surface_load.h"

namespace lumi::planner
{

// Instructions of a frame in RGB565 with the code of `core` ("m0plus", else M4 code). Within 10 % of 90 of the 132
// counts that it was fitted to, 21 % in the worst (four samples of a plain ball); 9 % in the root mean square.
// Triangles that are drawn in parts are unknown to the model, as they are large or cut by the image: nearer than two
// radii, and for meshes of some hundred triangles, counts are up to twice as high. What see-through triangles add is
// fitted to 48 counts of four fields: within 18 % of the frame, 8 % in the root mean square.
double surface_instructions(const std::string& core, SurfaceMode mode, const SurfaceLoad& load);

// Flash lines of so many bytes that a frame misses, about.
double surface_misses(const SurfaceLoad& load, double line_bytes);

// Frames of 240 × 240 pixels a second by one core, over poses all around the sphere.
struct PartRate {
    const Chip* chip;
    double mean, worst;
    double instructions;  // a frame, in the mean
};
std::vector<PartRate> surface_rates(const SeeThroughField& field, SurfaceMode mode);

inline constexpr int kRatedPoses = 200;

}  // namespace lumi::planner
