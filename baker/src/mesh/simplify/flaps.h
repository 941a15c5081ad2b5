// SPDX-License-Identifier: MIT
// Leaves out flaps: small surfaces at edges of more than two triangles, as meshes that were scanned or made coarser
// have them by the thousand.
#pragma once

#include "geometry/mesh.h"

namespace lumi::baker
{

// The triangles without those surfaces that are smaller than `small`, in square radii, that hang at the rest by an edge
// and leave no hole in it. No body loses more than a fiftieth of its area. A body is what shares no vertex with the
// rest. `surfaces`: by triangle, the number of the one that it is of.
std::vector<Mesh::Corners> without_flaps(const Mesh& mesh, const std::vector<uint32_t>& surfaces, double small);

}  // namespace lumi::baker
