// SPDX-License-Identifier: MIT
// Where a volume looks solid: the surface behind which more than half of the light is stopped on its way out.
#pragma once

#include "geometry/mesh.h"
#include "volume/volume.h"

namespace lumi::baker
{

// At each voxel the optical depth of the most open way out of the grid, of 26 straight ones: along axes and diagonals.
// In the volume's grid. Cost: 26 passes over the voxels, 8 bytes a voxel.
Grid optical_depths(const Volume& volume);

// The surface of optical depth log 2, in the volume's units and axes; empty where the volume is nowhere that thick.
Mesh opacity_surface(const Volume& volume);

}  // namespace lumi::baker
