// SPDX-License-Identifier: MIT
// Pictures from files that strangers may have made. Formats: PNG and JPEG with 8 bits a channel, Radiance .hdr and
// OpenEXR for radiance. Everything else is refused by name. The size is checked before a pixel is decoded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace lumi::baker
{

// The one set of limits, of every format.
inline constexpr int kMaxPictureSide = 32768;
inline constexpr int64_t kMaxPicturePixels = int64_t{1} << 27;  // 0.4 GB of memory with 8 bits, 1.6 GB of radiance
inline constexpr uintmax_t kMaxPictureFileBytes = uintmax_t{1} << 30;

// Why a picture is not read, such as "it ends too early"; what() names neither the file nor the mend.
struct PictureError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct DecodedPicture {
    int width = 0, height = 0;   // > 0
    std::vector<uint8_t> rgb;    // 3 bytes a pixel, top row first; grey is spread, 16 bits are rounded to 8
    std::vector<uint8_t> alpha;  // a byte a pixel; empty where the picture has none or nobody asked
};

// A PNG file; alpha is ignored. Notes the file as an input (file_guard.h). Throws PictureError.
DecodedPicture read_png(const std::filesystem::path& file);

}  // namespace lumi::baker
