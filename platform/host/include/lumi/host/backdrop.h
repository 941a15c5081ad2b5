// SPDX-License-Identifier: MIT
// A dark grey backdrop, lighter in the middle, against which black and white objects are seen alike: `lumi render` and
// pages of `lumi view` put it behind an object. Firmware has no part in it: the object is drawn over each of two greys,
// and every pixel lies between both. So what covers a pixel whole keeps its bits, and an outline or glass lets the
// backdrop through as core lets a colour through.
#pragma once

#include <stdint.h>

#include "lumi/color.h"

namespace lumi::host
{

// Cool greys that displays of 16 bits show as they are.
inline constexpr Rgb8 kBackdropCorner = {33, 36, 41}, kBackdropMiddle = {99, 101, 107};

// How much of the middle's grey a pixel shows, of 256: the more of it is gone, the farther from the middle, squared.
constexpr int32_t backdrop_share(int32_t x, int32_t y, int32_t width_px, int32_t height_px)
{
    const int64_t across = 2 * x + 1 - width_px, down = 2 * y + 1 - height_px;  // in halves of pixels
    const int64_t corner = int64_t{width_px} * width_px + int64_t{height_px} * height_px;
    return static_cast<int32_t>(256 - 256 * (across * across + down * down) / corner);
}

// Makes a display's pixel over the backdrop of what it shows there over both greys. Formats of 16 bits have too few
// greys for a gradient: they are dithered in order (Bayer), 4 × 4 pixels, where the backdrop shows.
template <class Pixel>
Rgb8 over_backdrop(const Rgb8& over_corner, const Rgb8& over_middle, int32_t share, int32_t x, int32_t y)
{
    const int32_t odd = x ^ y;
    const int32_t rank = (odd & 1) << 3 | (y & 1) << 2 | (odd & 2) | (y >> 1 & 1);  // 0 .. 15
    const auto level = [&](int32_t a, int32_t b, int32_t step) {
        if (a == b) return static_cast<uint8_t>(a);
        const int32_t value = (a * (256 - share) + b * share + (2 * rank - 15) * 8 * step + 128) >> 8;
        return static_cast<uint8_t>(value < 0 ? 0 : value > 255 ? 255 : value);
    };
    constexpr int32_t kStep = Pixel::kBytes == 2 ? 8 : 0;
    alignas(uint32_t) uint8_t pixel[4];
    Pixel::store(pixel, {level(over_corner.r, over_middle.r, kStep), level(over_corner.g, over_middle.g, kStep / 2),
                         level(over_corner.b, over_middle.b, kStep)});
    return Pixel::load(pixel);
}

}  // namespace lumi::host
