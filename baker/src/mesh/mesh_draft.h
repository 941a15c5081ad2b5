// SPDX-License-Identifier: MIT
// The mesh that is fitted: few triangles on the scene's surface, without edges that are too long.
#pragma once

#include "mesh/outside.h"
#include "mesh/patch_mesh.h"

namespace lumi::baker
{

struct MeshDraft {
    Mesh mesh;
    bool exact = false;  // every triangle of the scene's outside is there, whole or split: nothing has to be fitted
    bool fits = false;   // what can be seen of it may fit the format (lumi/surface/format.h)
};

template <class Io>
void fields(Io& io, MeshDraft& draft)
{
    io(draft.exact, draft.fits, draft.mesh);
}

// About as many triangles as `settings` ask for can be seen, before edges are split; hidden ones come on top.
MeshDraft drafted(const Outside& outside, const MeshSettings& settings, Job& job);

}  // namespace lumi::baker
