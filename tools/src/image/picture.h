// SPDX-License-Identifier: MIT
// Pictures as the tools handle them: 8 bits a channel, sRGB-encoded, three bytes a pixel, no padding, top row first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lumi/color.h"

namespace lumi::tools
{

struct Picture {
    int width_px = 0, height_px = 0;
    std::vector<uint8_t> rgb;  // 3 · width · height bytes

    Picture() = default;
    Picture(int width, int height, const Rgb8& colour = {0, 0, 0});

    uint8_t* pixel(int x, int y) { return rgb.data() + offset(x, y); }
    const uint8_t* pixel(int x, int y) const { return rgb.data() + offset(x, y); }

private:
    size_t offset(int x, int y) const
    {
        return 3 * (static_cast<size_t>(y) * static_cast<size_t>(width_px) + static_cast<size_t>(x));
    }
};

// Throws std::invalid_argument unless it holds. Sizes of pictures come from files of strangers, so that builds without
// assert() need this, too.
void check_precondition(bool holds, const char* what);

inline bool same_size(const Picture& a, const Picture& b)
{
    return a.width_px == b.width_px && a.height_px == b.height_px;
}

// c + (255 - a)·b/255, rounded, of one channel: in encoded values.
constexpr uint8_t over(uint8_t premultiplied, uint8_t coverage, uint8_t background)
{
    constexpr int kOpaque = 255;
    const int value = premultiplied + ((kOpaque - coverage) * background + kOpaque / 2) / kOpaque;
    return static_cast<uint8_t>(value > kOpaque ? kOpaque : value);
}

// Copies `source` into `target` with its top left corner at (x, y). Precondition: it fits.
void paste(const Picture& source, int x, int y, Picture& target);

}  // namespace lumi::tools
