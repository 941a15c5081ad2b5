// SPDX-License-Identifier: MIT
// What lies behind the object: a constant colour, or what the stripe already holds.
//
// A background policy has `kFills` (are uncovered pixels written?) and `under<Pixel>(pointer)`, the colour to blend
// with.
#pragma once

#include "lumi/pixel.h"

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

// Nothing: coverage goes into the pixels, for what is laid over something else later (LVGL, sprites). Pixels without
// coverage get the colour alone, black where there is none. Surface fields draw it; PixelArgb8888, PixelA8.
struct OverNothing {
    static constexpr bool kFills = true;
    static constexpr bool kIsBlack = false;
};

template <class Background>
inline constexpr bool kKeepsCoverage = false;
template <>
inline constexpr bool kKeepsCoverage<OverNothing> = true;

// Stores a colour that covers a part of a pixel, of 255.
template <class Pixel>
inline void store_part(uint8_t* pixel, const Rgb8& colour, uint8_t coverage)
{
    if constexpr (kHoldsCoverage<Pixel>)
        Pixel::store_covered(pixel, colour, coverage);
    else
        Pixel::store(pixel, colour);
}

// Stores what a background of the kind that fills shows where nothing covers it.
template <class Pixel, class Background>
inline void store_background(uint8_t* pixel, const Background& background)
{
    if constexpr (kKeepsCoverage<Background>)
        store_part<Pixel>(pixel, {0, 0, 0}, 0);
    else
        Pixel::store(pixel, background.template under<Pixel>(pixel));
}

}  // namespace lumi
