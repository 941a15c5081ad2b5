// SPDX-License-Identifier: MIT
// A camera's pose as other programs give it: a 4×4 matrix in a text file.
#pragma once

#include <array>
#include <string>

#include "lumi/camera.h"

namespace lumi::tools
{

// Row by row: [right up back eye; 0 0 0 1], from the camera's axes to those of the sphere. The camera looks along its
// -z and has y up, as in OpenGL, glTF and Blender. The sphere has radius 1, its centre at the origin, z up.
using Matrix4 = std::array<double, 16>;

// 16 numbers; what stands between them may be spaces, line ends, commas, semicolons and brackets. Throws Failure with
// the line.
Matrix4 read_matrix(const std::string& path);

// The pose of a rigid matrix; numbers of four digits are rigid enough, and are made exactly so. Throws Failure, which
// names `path`, for scale, shear, mirroring, and another last row.
Pose pose_of(const Matrix4& matrix, const std::string& path);

}  // namespace lumi::tools
