// SPDX-License-Identifier: MIT
// PNG files, for the baker, the tools and the simulator alike: libpng reads them, and stb_image_write writes them.
#pragma once

#include <string>

#include "lumi/host/picture.h"

namespace lumi::host
{

bool is_png(const std::string& bytes);

// Decodes any PNG. Checksums count: what is damaged or cut short is refused. Throws PictureError.
DecodedPicture decode_png(const std::string& bytes, bool with_alpha);

// The bytes of a PNG file. Throws std::length_error for a picture that is too large for stb_image_write, which counts
// bytes in an int: rows of more than 16,777,215 bytes, or more than about 2 GB of them.
std::string png_bytes(const PictureView& picture);

}  // namespace lumi::host
