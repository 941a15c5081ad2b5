// SPDX-License-Identifier: MIT
#include "lumi/host/picture.h"

namespace lumi::host
{
namespace
{

#ifdef LUMI_FUZZED  // there, thousands of inputs a second are worth more than large pictures (tests/fuzz)
constexpr int64_t kMostPixels = 1 << 14;
#else
constexpr int64_t kMostPixels = kMaxPicturePixels;
#endif

}  // namespace

void check_picture_size(int64_t width, int64_t height)
{
    const std::string size = std::to_string(width) + " by " + std::to_string(height) + " pixels";
    if (width < 1 || height < 1) throw PictureError("it has no pixels: " + size);
    if (width > kMaxPictureSide || height > kMaxPictureSide || width * height > kMostPixels) {
        throw PictureError("its size of " + size + " is too large; at most " + std::to_string(kMaxPictureSide) +
                           " a side and " + std::to_string(kMostPixels) + " in all are read");
    }
}

void check_picture_bytes(int64_t bytes, int64_t fewest)
{
    if (bytes < fewest) throw PictureError("it ends too early: its size needs more bytes");
}

}  // namespace lumi::host
