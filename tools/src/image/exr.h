// SPDX-License-Identifier: MIT
// OpenEXR files of linear light (lumi/baker/picture_file.h).
#pragma once

#include <string>

#include "lumi/baker/reference.h"

namespace lumi::tools
{

bool is_exr_name(const std::string& path);

// Says what is wrong with it as the name of views to trace; nothing if it ends in ".png", ".webp" or ".exr", or is a
// device or a pipe.
std::string wrong_reference_name(const std::string& path);

std::string exr_bytes(const baker::RadianceImage& image);

}  // namespace lumi::tools
