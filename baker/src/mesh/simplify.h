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

// Of `mesh` only positions and corners count, and the result has no more. Vertices are a subset of the mesh's, each
// used. About `triangles` remain, a quarter more at most; the shape's topology stays where that can be.
Simplified simplified(const Mesh& mesh, size_t triangles);

}  // namespace lumi::baker
