// SPDX-License-Identifier: MIT
// From the sums of a surface bake to what its file holds.
#pragma once

#include "fit/fit_state.h"
#include "pack/surface_writer.h"
#include "store/bake_stages.h"

namespace lumi::baker
{

// The sphere that a field file names, in scene units.
struct FieldSphere {
    std::array<double, 3> centre;
    double radius;
};

// About as much work as tracing so many light paths; less once it is known which vertices need no view table.
uint64_t solution_work(const FitState& state);

// A state of the light, traced; borrowed. Its light is divided by `scale`, a multiple of 1/16.
struct TracedLight {
    FitState& state;
    BakeStages& stages;
    std::string name = {};
    float scale = 1;
    Rgb usual = grey(1);   // its weight until another is chosen
    bool is_tint = false;  // it shows what is left after the first light is taken away
};

// The colours that fit best, in the format's bits. Leaves the sums in order. Takes all that is left of the job's work,
// less what the stages have of it. `kept`: the last entries of the see-through palette that stay as they are.
FieldParts solved(const std::vector<TracedLight>& lights, const FieldSphere& sphere, Job& job, size_t kept = 0);

}  // namespace lumi::baker
