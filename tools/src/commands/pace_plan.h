// SPDX-License-Identifier: MIT
// The surface field that shows most at a frame rate: few triangles drawn finely, or many drawn by one sample, with view
// tables or without.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "../planner/speed.h"
#include "lumi/baker/surface.h"

namespace lumi::tools
{

// A mesh with the light that one way of drawing shows of it.
struct PacedField {
    baker::SurfacePlan plan;
    SurfaceMode mode;
    double psnr_db;            // of a small bake
    double frames_per_second;  // of the first part that is asked for
    double share;              // of the pace, where it is worst: 1 and more keep it
};

struct PacePlan {
    PacedField chosen;
    std::optional<PacedField> slower, faster;  // the next that show more, and the next that leave time
};

// Bakes meshes of fewer and fewer triangles than `largest` with few light paths, counts what each costs in every mode,
// and measures what it shows. All of them may fill the limits with texels, which cost little time. Takes a few small
// bakes. Throws BakeError, Cancelled.
PacePlan plan_for_pace(const baker::Scene& scene, const baker::SurfacePlan& largest, const baker::SurfaceLimits& limits,
                       const std::vector<planner::Pace>& paces, const host::ScreenSize& screen,
                       const baker::ProgressCallback& progress);

// Three lines at most: the choice, and its neighbours.
std::string text_of(const PacePlan& plan, const planner::Pace& first);

}  // namespace lumi::tools
