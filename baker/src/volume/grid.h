// SPDX-License-Identifier: MIT
// A grid of scalars in space, as a reader of a file format delivers it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace lumi::baker
{

struct Grid {
    uint32_t nx = 0, ny = 0, nz = 0;
    std::vector<float> values;  // x fastest, then y; one at the centre of each voxel
    // Rows of the matrix that takes a voxel's (i, j, k, 1) to scene units and axes.
    std::array<std::array<double, 4>, 3> voxel_to_world = {};
};

}  // namespace lumi::baker
