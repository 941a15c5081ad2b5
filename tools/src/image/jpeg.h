// SPDX-License-Identifier: MIT
// Shows what JPEG does to a picture.
#pragma once

#include <string>

#include "image/picture.h"

namespace lumi::tools
{

// As lumi/baker/picture_file.h says.
std::string jpeg_bytes(const Picture& picture, int quality);

// The picture as it looks after the best quality whose file takes at most `bytes`, or after quality 1.
Picture through_jpeg(const Picture& picture, size_t bytes);

}  // namespace lumi::tools
