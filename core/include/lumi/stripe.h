// SPDX-License-Identifier: MIT
// A stripe tells where a renderer writes pixels.
#pragma once
#pragma GCC system_header

#include <stddef.h>
#include <stdint.h>

#include "lumi/detail/compiler.h"
#include "lumi/detail/work.h"

namespace lumi
{

// This is a rectangle in the caller's memory: rows of width_px pixels, stride_bytes apart, top row first. It may lie
// beside the image, wholly or in part. With 16-bit pixels, address and stride are even.
struct Stripe {
    uint8_t* pixels;
    int32_t x_px, y_px;  // where its first pixel is in the image
    int32_t width_px, height_px;
    uint32_t stride_bytes;

    // Return one beyond its last column and row; at most INT32_MAX, which lies beside every image.
    int32_t right_px() const { return end_of(x_px, width_px); }
    int32_t bottom_px() const { return end_of(y_px, height_px); }

private:
    static int32_t end_of(int32_t begin, int32_t size) { return begin > INT32_MAX - size ? INT32_MAX : begin + size; }
};

// This is a rectangle of the image; it is nothing where a side is 0.
struct PixelRect {
    int32_t x_px, y_px, width_px, height_px;
};

// Beside these rectangles a frame has the same pixels as the one before.
struct ChangedRects {
    static constexpr uint32_t kMost = 4;
    PixelRect rect[kMost];
    uint32_t count;
};

// Returns where a pixel of the stripe lies in memory.
template <class Pixel>
uint8_t* pixel_of(const Stripe& stripe, int32_t x, int32_t y)
{
    return stripe.pixels + static_cast<size_t>(y - stripe.y_px) * stripe.stride_bytes +
           static_cast<uint32_t>(x - stripe.x_px) * Pixel::kBytes;
}

}  // namespace lumi

namespace lumi::detail
{

// Holds columns of the image, or its scanlines: [begin, end).
struct Extent {
    int32_t begin, end;
};

}  // namespace lumi::detail
