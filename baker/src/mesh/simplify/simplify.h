// SPDX-License-Identifier: MIT
// Fewer triangles for nearly the same shape.
#pragma once

#include "geometry/mesh.h"

namespace lumi::baker
{

// Reads only the positions and corners of `mesh`, and the result has no more than these. Vertices are a subset of the
// mesh's, each used. About `triangles` remain. The shape's topology may change. `openness` says by vertex how much of
// the surface there is seen, 0 .. 1, so that what is seen more keeps more triangles; empty: all alike.
Mesh simplified(const Mesh& mesh, size_t triangles, const std::vector<float>& openness = {});

}  // namespace lumi::baker
