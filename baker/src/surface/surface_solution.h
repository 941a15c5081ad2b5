// SPDX-License-Identifier: MIT
// From the sums of a surface bake to what its file holds.
#pragma once

#include "surface/surface_state.h"
#include "surface/surface_writer.h"

namespace lumi::baker
{

// Of a file: its sphere, in scene units.
struct SurfaceSphere {
    std::array<double, 3> centre;
    double radius;
};

// The colours that fit best, in the format's bits. Leaves the sums in order.
SurfaceParts solved(SurfaceState& state, bool view_tables, const SurfaceSphere& sphere, Job& job);

}  // namespace lumi::baker
