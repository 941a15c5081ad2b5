// SPDX-License-Identifier: MIT
// Fewer triangles for nearly the same shape.
#pragma once

#include "geometry/mesh.h"

namespace lumi::baker
{

struct Simplified {
    Mesh mesh;
    bool rough = false;  // the shape's topology was given up
};

// Reads only the positions and corners of `mesh`, and the result has no more than these. Vertices are a subset of the
// mesh's, each used. About `triangles` remain, a quarter more at most; the shape's topology stays where that can be.
Simplified simplified(const Mesh& mesh, size_t triangles);

}  // namespace lumi::baker
