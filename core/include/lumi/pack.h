// SPDX-License-Identifier: MIT
// Stripes of PixelGrey8 packed for displays of 16 greys or two, and stripes of PixelRgb888 for those of 5, 6 and 5
// bits, by ordered dither (Bayer's 8 × 8 matrix). Thresholds hang on places in the image, so a frame is the same
// however it is cut into stripes.
//
//     view.draw({grey, 0, y, 128, 8, 128});                // Screen<128, 64, 8, PixelGrey8>
//     pack_grey4({grey, 0, y, 128, 8, 128}, grey, 64);     // in place: 64 bytes a row
//
// Dither takes place on encoded values, as blending does. `out` may be the stripe's own memory, if its rows are no
// farther apart than the stripe's.
#pragma once
#pragma GCC system_header

#include "lumi/stripe.h"

namespace lumi
{

// Two pixels a byte, the left one in the high bits. A last lone pixel has zeros beside it.
void pack_grey4(const Stripe& grey, uint8_t* out, uint32_t out_stride_bytes);

// Eight pixels a byte, the left one in the highest bit: e-paper. 1 is light.
void pack_mono1(const Stripe& grey, uint8_t* out, uint32_t out_stride_bytes);

// Eight rows a byte, the upper one in the lowest bit, a byte for each column: pages of OLED controllers such as the
// SSD1306. The stripe has a multiple of 8 rows.
void pack_pages(const Stripe& grey, uint8_t* out, uint32_t out_stride_bytes);

// Two bytes a pixel, as PixelRgb565 and PixelRgb565Swapped store them, from stripes of PixelRgb888: soft gradients
// without bands. `out` and its stride are even.
void dither_rgb565(const Stripe& rgb, uint8_t* out, uint32_t out_stride_bytes);
void dither_rgb565_swapped(const Stripe& rgb, uint8_t* out, uint32_t out_stride_bytes);

constexpr uint32_t grey4_bytes(int32_t width_px)
{
    return (static_cast<uint32_t>(width_px) + 1) / 2;
}
constexpr uint32_t mono1_bytes(int32_t width_px)
{
    return (static_cast<uint32_t>(width_px) + 7) / 8;
}

}  // namespace lumi
