// SPDX-License-Identifier: MIT
// What a draft holds.
#pragma once

#include "lumi/baker/surface.h"
#include "surface/surface_mesh.h"

namespace lumi::baker
{

struct SurfaceDraft::Contents {
    BuiltSurface built;
};

}  // namespace lumi::baker
