// SPDX-License-Identifier: MIT
// Closes seams between parts that lie beside each other, such as a car's bonnet and its wings.
#pragma once

#include "geometry/mesh.h"

namespace lumi::baker
{

// Vertices of borders that lie at most `reach` from a border of another part become one with the first of them that
// lies as near; triangles that have two such corners go. Without this, simplification cuts off each border for itself,
// and a seam that nobody saw gapes. A part is what shares no vertex with the rest. One whose area would change much
// by this keeps its vertices. Positions stay, used or not.
Mesh with_closed_seams(const Mesh& mesh, float reach);

}  // namespace lumi::baker
