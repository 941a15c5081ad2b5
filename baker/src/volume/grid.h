// SPDX-License-Identifier: MIT
// A grid of scalars in space, as a reader of a file format delivers it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "volume/affine.h"

namespace lumi::baker
{

struct Grid {
    uint32_t nx = 0, ny = 0, nz = 0;
    std::vector<float> values;  // x fastest, then y; one at the centre of each voxel
    // Rows of the matrix that takes a voxel's (i, j, k, 1) to scene units and axes.
    std::array<std::array<double, 4>, 3> voxel_to_world = {};
};

// Checks that every reader of a volume's file makes before it takes memory for a grid. All throw SceneError; `name` is
// the file's.

inline constexpr int64_t kMaxVoxels = int64_t{1} << 28;  // 1 GB of memory; 512 x 512 x 1024
inline constexpr int64_t kMaxVoxelsASide = 32767;        // NIfTI-1 cannot say more

// There must be 2 to kMaxVoxelsASide voxels a side, at most kMaxVoxels in all.
void require_size(const std::string& name, const std::array<int64_t, 3>& sides);

// The matrix must be finite, not too far away, and invertible. `method` is what the file's format calls the matrix.
void require_place(const std::string& name, const Affine& voxel_to_world, const std::string& method);

}  // namespace lumi::baker
