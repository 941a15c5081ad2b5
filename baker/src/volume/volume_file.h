// SPDX-License-Identifier: MIT
// Reads grids from files; the end of a name tells which format it has.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include "volume/grid.h"

namespace lumi::baker
{

// Whether its name ends in .nii, .nii.gz or .vdb.
bool is_volume_file(const std::filesystem::path& file);

// Throws SceneError with the mend if the name is that of a volume in a format that is not read: NRRD, DICOM, MetaImage.
void refuse_foreign_volume(const std::filesystem::path& file);

// By read_vdb() if the name ends so, else by read_nifti(). Throws SceneError.
Grid read_grid(const std::filesystem::path& file);

// Returns "-1024 to 3071": the least and the greatest value, for messages.
std::string range_of(const Grid& grid);

// OpenVDB does two things for us: it reads its own files, and finds surfaces in grids. It is a module (openvdb_module),
// which is loaded at the first call: both functions also throw SceneError where lumi was built without it.

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
// depths under its surface. All values are finite, size and matrix within the limits of grid.h.
// Throws SceneError. Reads only that grid: memory is its tree and 4 bytes a voxel of the box. OpenVDB trusts what it
// reads: files that are no more than cut short are refused, but one that was made to do harm may do it.
Grid read_vdb(const std::filesystem::path& file);

// The program sees so the module that links OpenVDB.
struct OpenvdbModule {
    // As read_vdb(), of a file that is open; `name` is the file's.
    Grid (*read)(std::istream& stream, const std::string& name);
    Polygons (*dual_contour)(const Grid& grid, float value);
};

inline constexpr char kOpenvdbModuleFile[] = "lumi_openvdb.so";
// The module's one symbol: a function of no arguments that returns a pointer to an OpenvdbModule, which lives as long
// as the program.
inline constexpr char kOpenvdbModuleSymbol[] = "lumi_openvdb_module";

}  // namespace lumi::baker
