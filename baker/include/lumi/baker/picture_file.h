// SPDX-License-Identifier: MIT
// The one reader and the one writer of PNG and of JPEG, with 8 bits a channel; for radiance the baker also reads
// Radiance .hdr and OpenEXR, and writes OpenEXR. Strangers may have made the files: the size is checked before a pixel
// is decoded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
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

// The bytes of a JPEG file, grey or colour, sequential or progressive; not CMYK. What is damaged or cut short is
// refused. Throws PictureError.
DecodedPicture decode_jpeg(const std::string& bytes);

// Borrowed pixels: 3 bytes each, top row first, without gaps. At least one.
struct PictureView {
    int width, height;
    const uint8_t* rgb;
};

// The bytes of files. Throw std::length_error for a picture that no such file can hold. JPEG: baseline, as decoders of
// firmware read it, with chroma of half the resolution; quality 1 to 100.
std::string png_bytes(const PictureView& picture);
std::string jpeg_bytes(const PictureView& picture, int quality);

// Borrowed pixels of linear light: red, green and blue (Rec. 709 primaries), multiplied by the coverage that follows.
// Top row first, without gaps. At least one.
struct RadianceView {
    int width, height;
    const float* rgba;
};

// The bytes of an OpenEXR file: one part, scanlines, channels A, B, G and R of 32 bits, packed without loss.
std::string exr_bytes(const RadianceView& picture);

}  // namespace lumi::baker
