// SPDX-License-Identifier: MIT
// Triangles that lie where another one does: double-sided exports write each face twice.
#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace lumi::baker
{

// For each triangle the lowest number of all that have its three vertices, in whatever order; for the halves of a quad
// that is cut along one diagonal, where an earlier one is cut along the other, a half of that one. Vertices at one
// place must be one.
std::vector<uint32_t> first_copies(const Mesh& mesh);

}  // namespace lumi::baker
