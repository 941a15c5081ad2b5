// SPDX-License-Identifier: MIT
// Leaves out crumbs: the small pieces of a surface that noise makes.
#pragma once

#include "geometry/mesh.h"

namespace lumi::baker
{

// Keeps the triangles of those pieces, connected by common vertices, that have at least the share `least` (0 to 1) of
// the largest one's area, and the positions that they use.
void keep_large_pieces(Mesh& mesh, double least);

}  // namespace lumi::baker
