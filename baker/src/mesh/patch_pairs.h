// SPDX-License-Identifier: MIT
// Triangles in pairs that can share a rectangle of texels.
#pragma once

#include "mesh/patch_mesh.h"

namespace lumi::baker
{

// Each triangle in one patch. Pairs share two vertices of `mesh` and are near to parallelograms with right angles;
// few triangles stay alone: their corner a is the one opposite the longest edge. Only positions and corners count.
std::vector<PatchMesh::Patch> paired(const Mesh& mesh);

}  // namespace lumi::baker
