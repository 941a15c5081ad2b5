// SPDX-License-Identifier: MIT
// Shorter edges: triangles are split, and their neighbours with them.
#pragma once

#include <functional>

#include "geometry/mesh.h"
#include "mesh/mesh_tracer.h"

namespace lumi::baker
{

// Where the vertex goes that splits an edge: its middle, the direction that the triangles beside it face (unit
// length), the edge's length. At most a tenth of that length from the middle.
using PlaceMiddle = std::function<Vec3(const Vec3& middle, const Vec3& facing, float length)>;

// Moves the middle of an edge onto the surface, where that is near and faces the same way. Another part may be within
// reach, too, such as the second of two bars; the edge's own is the nearest one. Borrows the tracer.
PlaceMiddle onto(const MeshTracer& fronts);

// Only positions and corners count. The longest edge is split first, in all its triangles at once, so no vertex ends
// up on another triangle's edge. Edges of one triangle alone are split in the middle.
Mesh with_short_edges(Mesh mesh, float longest, const PlaceMiddle& place);

// A mesh as a surface field holds it: positions in fixed point.

// Positions in steps of 2^-14, at most 1 from the centre; vertices that fall together are one, triangles without area
// go, and vertices without a triangle, too. Only positions and corners count.
Mesh rounded(const Mesh& mesh);

}  // namespace lumi::baker
