// SPDX-License-Identifier: MIT
// What lies behind the object: a constant colour, or what the stripe already holds.
//
// A background policy has `kFills` (are uncovered pixels written?) and `under<Pixel>(pointer)`, the colour to blend
// with.
#pragma once

#include "lumi/color.h"

namespace lumi
{

// Black, the cheapest: OLED panels, dark dashboards.
struct OverBlack {
    static constexpr bool kFills = true;
    static constexpr bool kIsBlack = true;

    template <class Pixel>
    Rgb8 under(const uint8_t*) const
    {
        return {0, 0, 0};
    }
};

struct OverColour {
    static constexpr bool kFills = true;
    static constexpr bool kIsBlack = false;
    Rgb8 colour;

    template <class Pixel>
    Rgb8 under(const uint8_t*) const
    {
        return colour;
    }
};

struct OverStripe {
    static constexpr bool kFills = false;
    static constexpr bool kIsBlack = false;

    template <class Pixel>
    Rgb8 under(const uint8_t* pixel) const
    {
        return Pixel::load(pixel);
    }
};

}  // namespace lumi
