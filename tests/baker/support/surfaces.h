// SPDX-License-Identifier: MIT
// Surface meshes of whole scenes.
#pragma once

#include "mesh/patch_mesh.h"
#include "store/bake_stages.h"

namespace lumi::baker::testing
{

inline BuiltMesh built_mesh(const Scene& scene, const MeshSettings& settings)
{
    const ProgressCallback silent;
    Job job(1, 2, silent);
    BakeStages nothing_kept({}, {});
    return build_mesh(scene.data(), settings, nothing_kept, job);
}

// In the order that the field counts them, lone ones once.
inline Mesh triangles_of(const PatchMesh& surface)
{
    Mesh mesh;
    mesh.positions = surface.positions;
    for (const PatchMesh::Patch& p : surface.patches) {
        mesh.corners.push_back({p.a, p.b, p.c});
        if (p.d != PatchMesh::kNone) mesh.corners.push_back({p.d, p.c, p.b});
    }
    return mesh;
}

}  // namespace lumi::baker::testing
