// SPDX-License-Identifier: MIT
// Measures the errors of a mesh.
#pragma once

#include <string>
#include <vector>

#include "geometry/view_cap.h"
#include "lumi/baker/surface.h"
#include "mesh/mesh_tracer.h"
#include "mesh/survey.h"
#include "scene/scene_data.h"
#include "util/job.h"

namespace lumi::baker
{

// The parts of a scene's silhouettes that a mesh leaves out.

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

template <class Io>
void fields(Io& io, MeshLoss& loss)
{
    io(loss.missed, loss.missed_see_through, loss.added, loss.displaced, loss.thin, loss.holes, loss.largest_hole);
}

// `see_through`: what else is there, wherever a ray meets it.
MeshLoss loss_of(const SceneData& scene, const MeshTracer& tracer, Job& job, const ViewCap& cap = {},
                 const MeshTracer* see_through = nullptr);

// Triangles of a mesh that can be seen. Ask for no more than the scene has.
struct MeshCount {
    size_t asked, got;
    bool all = false;  // the scene has no more
};

// `of_volume`: the mesh is a volume's shell.
std::vector<MeshWarning> mesh_warnings(const MeshLoss& loss, const MeshCount& triangles, bool of_volume);

}  // namespace lumi::baker
