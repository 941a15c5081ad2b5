// SPDX-License-Identifier: MIT
#include "draw/over_photo.h"

#include <algorithm>

namespace lumi::tools
{

Picture over_photo(const Picture& over_black, const Picture& over_white, const Picture& photo)
{
    constexpr int kOpaque = 255;
    Picture result = over_black;
    for (size_t i = 0; i < result.rgb.size(); ++i) {
        const int seen_through = std::max(0, over_white.rgb[i] - over_black.rgb[i]);
        const int value = over_black.rgb[i] + (seen_through * photo.rgb[i] + kOpaque / 2) / kOpaque;
        result.rgb[i] = static_cast<uint8_t>(std::min(value, kOpaque));
    }
    return result;
}

}  // namespace lumi::tools
