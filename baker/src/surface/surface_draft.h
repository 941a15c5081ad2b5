// SPDX-License-Identifier: MIT
// What a draft holds.
#pragma once

#include "lumi/baker/surface.h"
#include "mesh/patch_mesh.h"

namespace lumi::baker
{

struct SurfaceDraft::Contents {
    BuiltMesh built;
};

}  // namespace lumi::baker
