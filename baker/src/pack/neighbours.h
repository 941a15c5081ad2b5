// SPDX-License-Identifier: MIT
// Which triangle lies across each side of a patch (kNeighbourSection of lumi/surface/format.h).
#pragma once

#include <array>

#include "mesh/patch_mesh.h"

namespace lumi::baker
{

// In the order that the section has them; format::kNoNeighbour where the mesh ends, or where more than two triangles
// meet. Vertices at one place are one here, whatever their normals.
std::vector<std::array<uint16_t, 4>> neighbours_of(const PatchMesh& mesh);

}  // namespace lumi::baker
