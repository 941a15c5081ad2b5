// SPDX-License-Identifier: MIT
// PNG and JPEG with 8 bits a channel (lumi/host/picture.h); for radiance the baker also reads Radiance .hdr and
// OpenEXR, and writes OpenEXR. Strangers may have made the files: the size is checked before a pixel is decoded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "lumi/host/picture.h"

namespace lumi::baker
{

using host::DecodedPicture;
using host::kMaxPictureSide;
using host::PictureError;

inline constexpr uintmax_t kMaxPictureFileBytes = uintmax_t{1} << 30;

// A PNG file, with its alpha. Notes the file as an input (file_guard.h). Throws PictureError.
DecodedPicture read_png(const std::filesystem::path& file);

// The bytes of a JPEG file, grey or colour, sequential or progressive; not CMYK. What is damaged or cut short is
// refused. Throws PictureError.
DecodedPicture decode_jpeg(const std::string& bytes);

// Borrowed pixels of linear light: red, green and blue (Rec. 709 primaries), multiplied by the coverage that follows.
// Top row first, without gaps. At least one.
struct RadianceView {
    int width, height;
    const float* rgba;
};

// Returns the bytes of an OpenEXR file: one part, scanlines, channels A, B, G and R of 32 bits, packed without loss.
std::string exr_bytes(const RadianceView& picture);

}  // namespace lumi::baker
