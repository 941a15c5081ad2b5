// SPDX-License-Identifier: MIT
// What of a scene's silhouettes a mesh leaves out.
#pragma once

#include "geometry/view_cap.h"
#include "mesh/mesh_tracer.h"
#include "scene/scene_data.h"
#include "util/job.h"

namespace lumi::baker
{

inline constexpr uint32_t kSilhouettes = 24;      // directions, spread over the sphere
inline constexpr uint32_t kSilhouetteSize = 240;  // pixels across the unit sphere, each way

inline constexpr uint32_t kMaxMissing = 2;  // pixels: nobody minds a region of so few

struct MissingPixels {
    uint32_t scene = 0;    // pixels that the scene covers, in all silhouettes
    uint32_t missing = 0;  // those of them that the mesh should cover and does not
    uint32_t largest = 0;  // pixels in the largest connected region of missing ones
    uint32_t regions = 0;  // connected regions of more than kMaxMissing missing pixels
};

// Outlines may be off by one pixel: a missing pixel either has the scene all around, or the mesh is nowhere beside it
// and the scene is two pixels thick there. Directions outside of the cap do not count.
MissingPixels missing_pixels(const SceneData& scene, const MeshTracer& mesh, Job& job, const ViewCap& cap = {});

}  // namespace lumi::baker
