// SPDX-License-Identifier: MIT
// Surface meshes of whole scenes.
#pragma once

#include "surface/bake_stages.h"
#include "surface/surface_mesh.h"

namespace lumi::baker::testing
{

inline BuiltSurface built_surface(const Scene& scene, const SurfaceMeshSettings& settings)
{
    const ProgressCallback silent;
    Job job(1, 2, silent);
    BakeStages nothing_kept({}, {});
    return build_surface_mesh(scene.data(), settings, nothing_kept, job);
}

// In the order that the field counts them, lone ones once.
inline Mesh triangles_of(const SurfaceMesh& surface)
{
    Mesh mesh;
    mesh.positions = surface.positions;
    for (const SurfaceMesh::Patch& p : surface.patches) {
        mesh.corners.push_back({p.a, p.b, p.c});
        if (p.d != SurfaceMesh::kNone) mesh.corners.push_back({p.d, p.c, p.b});
    }
    return mesh;
}

}  // namespace lumi::baker::testing
