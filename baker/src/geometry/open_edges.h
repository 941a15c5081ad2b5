// SPDX-License-Identifier: MIT
// Where a mesh is open, with vertices at one place taken for one.
#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace lumi::baker
{

// Corners of each triangle as numbers of places.
std::vector<Mesh::Corners> places_of(const Mesh& mesh);

// Counts by material the edges that have a triangle on one side only. `places`: those of the mesh.
std::vector<size_t> open_edges(const Mesh& mesh, const std::vector<Mesh::Corners>& places, size_t materials);

// How flat the parts of each material are that hang together: the length of the sum of their area vectors over the sum
// of their areas. 1 where they are plane, 0 where they are closed; a cube without a face has 0.2, a bowl about 0.5.
std::vector<float> flatnesses(const Mesh& mesh, const std::vector<Mesh::Corners>& places, size_t materials);

// How thick the bodies of each material are: exact for plates, of which it is the volume over half of the surface.
// Others are as thick as their box is on its shortest side. 0 where the triangles enclose nothing, as those of a sheet.
std::vector<float> thicknesses(const Mesh& mesh, size_t materials);

}  // namespace lumi::baker
