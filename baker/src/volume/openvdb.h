// SPDX-License-Identifier: MIT
// OpenVDB does two things for us: it reads its own files, and finds surfaces in grids. It is a module (openvdb_module),
// which is loaded at the first call: both functions also throw SceneError where lumi was built without it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "volume/grid.h"

namespace lumi::baker
{

struct Polygons {
    std::vector<std::array<float, 3>> points;  // in voxels
    std::vector<std::array<uint32_t, 3>> triangles;
    std::vector<std::array<uint32_t, 4>> quads;
};

// Dual contouring. What is below `value` is inside, as is all that lies outside the grid; polygons face away from it.
// The result is the same for any number of threads. Memory: 8 bytes a voxel, and the polygons.
Polygons dual_contour(const Grid& grid, float value);

// Reads the grid of floats with the name "density", or else the only one: the box of its active voxels and, as
// values run linearly to what lies beyond, one voxel more on each side. Inactive voxels hold the background or their
// tile's value, as OpenVDB reads them. Units and axes are the file's. A level set is turned over: its values become
// depths under its surface. All values are finite, size and matrix within grid_limits.h.
// Throws SceneError. Reads only that grid: memory is its tree and 4 bytes a voxel of the box. OpenVDB trusts what it
// reads: files that are no more than cut short are refused, but one that was made to do harm may do it.
Grid read_vdb(const std::filesystem::path& file);

}  // namespace lumi::baker
