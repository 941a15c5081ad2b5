// SPDX-License-Identifier: MIT
// Fewer triangles for nearly the same shape.
#pragma once

#include "geometry/mesh.h"

namespace lumi::baker
{

// Reads only the positions and corners of `mesh`, and the result has no more than these. Vertices are a subset of the
// mesh's, each used. About `triangles` remain. The shape's topology may change.
Mesh simplified(const Mesh& mesh, size_t triangles);

}  // namespace lumi::baker
