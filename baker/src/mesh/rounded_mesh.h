// SPDX-License-Identifier: MIT
// A mesh as a surface field holds it: positions in fixed point.
#pragma once

#include "geometry/mesh.h"

namespace lumi::baker
{

// Positions in steps of 2^-14, at most 1 from the centre; vertices that fall together are one, triangles without area
// go, and vertices without a triangle, too. Only positions and corners count.
Mesh rounded(const Mesh& mesh);

}  // namespace lumi::baker
