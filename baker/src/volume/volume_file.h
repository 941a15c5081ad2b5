// SPDX-License-Identifier: MIT
// Grids from files of every format that is read; the end of a name tells which.
#pragma once

#include <filesystem>
#include <string>

#include "volume/grid.h"

namespace lumi::baker
{

// .nii, .nii.gz or .vdb.
bool is_volume_file(const std::filesystem::path& file);

// Throws SceneError with the mend if the name is that of a volume in a format that is not read: NRRD, DICOM, MetaImage.
void refuse_foreign_volume(const std::filesystem::path& file);

// By read_vdb() if the name ends so, else by read_nifti(). Throws SceneError.
Grid read_grid(const std::filesystem::path& file);

// "-1024 to 3071": the least and the greatest value, for messages.
std::string range_of(const Grid& grid);

}  // namespace lumi::baker
