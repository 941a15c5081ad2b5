// SPDX-License-Identifier: MIT
// What JPEG does to a picture.
#pragma once

#include <string>

#include "image/picture.h"

namespace lumi::tools
{

// Baseline JPEG, as decoders of firmware read it, with chroma of half the resolution. Quality 1 to 100. Precondition:
// at least one pixel.
std::string jpeg_bytes(const Picture& picture, int quality);

// The picture as it looks after the best quality whose file takes at most `bytes`, or after quality 1.
Picture through_jpeg(const Picture& picture, size_t bytes);

}  // namespace lumi::tools
