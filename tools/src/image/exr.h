// SPDX-License-Identifier: MIT
// OpenEXR files of linear light (lumi/baker/picture_file.h).
#pragma once

#include <string>

#include "lumi/baker/reference.h"

namespace lumi::tools
{

bool is_exr_name(const std::string& path);

// What is wrong with it as the name of a picture in either format; nothing if it ends in ".png" or ".exr", or is a
// device or a pipe.
std::string wrong_png_or_exr_name(const std::string& path);

// Writes by write_output: throws Failure and leaves earlier output where that fails.
void write_exr(const std::string& path, const baker::RadianceImage& image);

}  // namespace lumi::tools
