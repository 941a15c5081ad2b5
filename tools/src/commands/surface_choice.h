// SPDX-License-Identifier: MIT
// Whether a scene is baked into a surface field, and into which one: the default of `lumi bake`.
#pragma once

#include <string>

#include "../planner/surface_plan.h"

namespace lumi::tools
{

// Shares of the light paths that meet a scene: if more miss its mesh, --layout auto takes a chord field. The edge of a
// volume is soft, so many of its paths stop off the mesh and no hole is seen (docs/log/surface.md). Leaves that are
// left out of a cloud of them may be as many.
inline constexpr double kMostMissed = 0.05, kMostMissedOfVolume = 0.25;
// The same of what the mesh adds or displaces, other than in volumes.
inline constexpr double kMostWrong = 0.3;

struct SurfaceChoice {
    planner::SurfacePlan plan;  // without a draft where there can be no surface field
    std::string against;        // why a chord field does the scene more justice, with figures; empty: it does not
};

// Drafts meshes. Throws Interrupted.
SurfaceChoice surface_choice(const baker::Scene& scene, const planner::SurfaceTask& task,
                             const baker::ProgressCallback& progress);

// "about 5,500 triangles, 93.4 texels a radius, at most 499 kB".
std::string text_of(const planner::SurfacePlan& plan);
// "39.8 kB of RAM, for which it has fewer triangles than 3684"; empty where the plan has no limit of RAM.
std::string ram_text(const planner::SurfacePlan& plan);

}  // namespace lumi::tools
