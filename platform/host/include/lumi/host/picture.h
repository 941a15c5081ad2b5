// SPDX-License-Identifier: MIT
// Pictures of 8 bits a channel, and the limits that readers of all formats check before they decode a pixel, since
// strangers may have made the files.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace lumi::host
{

inline constexpr int kMaxPictureSide = 32768;
inline constexpr int64_t kMaxPicturePixels = int64_t{1} << 27;  // 0.4 GB of memory with 8 bits, 1.6 GB of radiance

// Why a picture is not read, such as "it ends too early"; what() names neither the file nor the mend.
struct PictureError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct DecodedPicture {
    int width = 0, height = 0;   // > 0
    std::vector<uint8_t> rgb;    // 3 bytes a pixel, top row first; grey is spread, 16 bits are rounded to 8
    std::vector<uint8_t> alpha;  // a byte a pixel; empty where the picture has none or nobody asked
};

// These pixels are borrowed: `channels` bytes each, top row first, without gaps. At least one. A fourth channel is
// alpha, by which the colours are not multiplied.
struct PictureView {
    int width, height;
    const uint8_t* pixels;
    int channels = 3;
};

// Throws PictureError unless the picture has pixels, and not too many of them.
void check_picture_size(int64_t width, int64_t height);

// Throws PictureError where `bytes` are fewer than any picture of this size can be packed into, so that a few bytes
// never claim much memory.
void check_picture_bytes(int64_t bytes, int64_t fewest);

}  // namespace lumi::host
