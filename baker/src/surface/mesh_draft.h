// SPDX-License-Identifier: MIT
// The mesh that is fitted: few triangles on the scene's surface, without edges that are too long.
#pragma once

#include "proxy/proxy_outside.h"
#include "surface/surface_mesh.h"

namespace lumi::baker
{

struct MeshDraft {
    Mesh mesh;
    bool rough = false;  // the shape's topology was given up
    bool fits = false;   // what can be seen of it may fit the format (lumi/surface_format.h)
};

// About as many triangles as `settings` ask for can be seen, before edges are split; hidden ones come on top.
MeshDraft drafted(const SceneData& scene, const Outside& outside, const SurfaceMeshSettings& settings, Job& job);

}  // namespace lumi::baker
