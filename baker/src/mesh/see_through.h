// SPDX-License-Identifier: MIT
// The parts of a scene that one sees through, apart from the others.
//
// See-through is what lets a share of the light pass straight: an opacity below 1, also where a picture says it softly.
// A picture that is nearly all 0 or 1 cuts holes and stays opaque, and so do bodies of glass, which bend what is
// behind.
#pragma once

#include "mesh/patch_mesh.h"

namespace lumi::baker
{

// By material. None where the scene has a volume, whose light is mixed into everything.
std::vector<bool> see_through_materials(const SceneData& scene);

// The scene without its see-through triangles, in its own frame and without light: what opaque meshes are made from.
// Null where the scene has no see-through triangle.
std::unique_ptr<SceneData> opaque_part(const SceneData& scene);

// At most about so many.
struct SeeThroughCount {
    uint32_t triangles;  // before edges are split
    uint32_t cards;      // the same of a cloud of cards, such as leaves: whole ones are left out, with a warning
    size_t patches;      // where splitting edges makes more, longer ones stay
};

// Appends the mesh of the see-through triangles: each side that is not hidden by opaque ones, also behind others. The
// loss becomes that of the whole scene. `opaque`: opaque_part().
void add_see_through(const SceneData& scene, const SceneData& opaque, const MeshSettings& settings,
                     const SeeThroughCount& most, BuiltMesh& built, Job& job);

}  // namespace lumi::baker
