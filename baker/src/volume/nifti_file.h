// SPDX-License-Identifier: MIT
// Reads volumes from NIfTI files, versions 1 and 2, of one file each (.nii), also packed by gzip (.nii.gz).
#pragma once

#include <filesystem>
#include <string>

#include "volume/grid.h"

namespace lumi::baker
{

// In millimetres; x points to the patient's right, y to the front, z up. Two voxels or more a side; values are scaled
// as the header says, and finite: what is no number becomes the smallest value of the file. The matrix can be inverted.
// Memory: the file, unpacked, and 4 bytes a voxel. Throws SceneError; no header makes it allocate more than
// nifti_header.h allows.
Grid read_nifti(const std::filesystem::path& file);

// Does the same with a file's bytes; `name` stands in messages.
Grid parse_nifti(const std::string& name, const std::string& bytes);

}  // namespace lumi::baker
