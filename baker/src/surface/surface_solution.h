// SPDX-License-Identifier: MIT
// From the sums of a surface bake to what its file holds.
#pragma once

#include "surface/bake_stages.h"
#include "surface/surface_state.h"
#include "surface/surface_writer.h"

namespace lumi::baker
{

// Of a file: its sphere, in scene units.
struct SurfaceSphere {
    std::array<double, 3> centre;
    double radius;
};

// About as much work as tracing so many light paths.
uint64_t solution_work(const SurfaceShape& shape);

// The colours that fit best, in the format's bits. Leaves the sums in order. Takes all that is left of the job's work,
// less what `stages` have of it.
SurfaceParts solved(SurfaceState& state, bool view_tables, const SurfaceSphere& sphere, BakeStages& stages, Job& job);

}  // namespace lumi::baker
