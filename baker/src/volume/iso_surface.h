// SPDX-License-Identifier: MIT
// The surface in a grid where its values cross a number.
#pragma once

#include "geometry/mesh.h"
#include "volume/grid.h"
#include "volume/volume.h"

namespace lumi::baker
{

// Dual contouring: about two triangles for each voxel that the surface crosses. What is above `value` is
// inside: triangles face away from it, and where it reaches the grid's border the surface is closed there by a flat
// cut. Positions are in the grid's world; no normals; every triangle has an area, and material 0. Empty if no value
// lies above, or none at or below. The same for any number of threads.
// Memory: 8 bytes a voxel, and the mesh.
Mesh iso_surface(const Grid& grid, float value);

// Gives every vertex the mean normal of its triangles, weighted by area.
void add_smooth_normals(Mesh& mesh);

// Keeps the triangles of those pieces, connected by common vertices, that have at least the share `least` (0 to 1) of
// the largest one's area, and the positions that they use.
void keep_large_pieces(Mesh& mesh, double least);

// Where a volume looks solid: the surface behind which more than half of the light is stopped on its way out.

// At each voxel the optical depth of the most open way out of the grid, of 26 straight ones: along axes and diagonals.
// In the volume's grid. Cost: 26 passes over the voxels, 8 bytes a voxel.
Grid optical_depths(const Volume& volume);

// The surface of optical depth log 2, in the volume's units and axes; empty where the volume is nowhere that thick.
Mesh opacity_surface(const Volume& volume);

}  // namespace lumi::baker
