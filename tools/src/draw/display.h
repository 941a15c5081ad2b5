// SPDX-License-Identifier: MIT
// From the bytes of a display to the picture that it shows.
#pragma once

#include <stdexcept>

#include "draw/draw.h"
#include "lumi/chord/render.h"
#include "lumi/pixel.h"

namespace lumi::tools
{

// Where the stripe lies in the picture, at x = 0.
template <class Pixel>
void copy_stripe(const Stripe& stripe, Picture& picture)
{
    for (int y = 0; y < stripe.height_px; ++y)
        for (int x = 0; x < stripe.width_px; ++x) {
            const uint8_t* bytes =
                stripe.pixels + static_cast<size_t>(y) * stripe.stride_bytes + static_cast<size_t>(x) * Pixel::kBytes;
            const Rgb8 colour = Pixel::load(bytes);  // a display shows this
            uint8_t* target = picture.pixel(x, stripe.y_px + y);
            target[0] = colour.r;
            target[1] = colour.g;
            target[2] = colour.b;
        }
}

// Calls `next` with a value of the display's pixel policy.
template <class Next>
Picture with_pixel(DisplayFormat display, const Next& next)
{
    switch (display) {
        case DisplayFormat::rgb888:
        case DisplayFormat::rgb565_dithered:  // whole pictures are dithered: views.cpp
            return next(PixelRgb888());
        case DisplayFormat::rgb565:
            return next(PixelRgb565());
        case DisplayFormat::grey8:
            return next(PixelGrey8());
    }
    throw std::logic_error("unknown display format");
}

}  // namespace lumi::tools
