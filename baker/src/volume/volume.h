// SPDX-License-Identifier: MIT
// A medium in its scene's units and axes: what a reader of a scene file delivers.
#pragma once

#include "volume/grid.h"
#include "volume/transfer_function.h"

namespace lumi::baker
{

struct Volume {
    Grid grid;  // two voxels or more a side, of finite values; its matrix can be inverted
    TransferFunction transfer;
    float anisotropy = 0;  // mean cosine of a scattering
};

// Corners, in the scene's units and axes, of the parts of the grid that hold any density; none if it is empty.
std::vector<Vec3> corners_of(const Volume& volume);

}  // namespace lumi::baker
