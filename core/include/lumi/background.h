// SPDX-License-Identifier: MIT
// Backgrounds lie behind the object: a constant colour, or the pixels that the stripe already holds.
//
// A background policy has `kFills` (are uncovered pixels written?) and `under<Pixel>(pointer)`, the colour to blend
// with.
#pragma once
#pragma GCC system_header

#include "lumi/pixel.h"
#include "lumi/stripe.h"

namespace lumi
{

// Black is the cheapest background: it suits OLED panels and dark dashboards.
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

// Nothing lies behind: coverage goes into the pixels, for what is laid over something else later (LVGL, sprites).
// Pixels without coverage get the colour alone, black where there is none. Surface fields draw it; PixelArgb8888,
// PixelA8.
struct OverNothing {
    static constexpr bool kFills = true;
    static constexpr bool kIsBlack = false;
};

}  // namespace lumi

namespace lumi::detail
{

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

// Writes `count` pixels of a background of the kind that fills.
template <class Pixel, class Background>
void fill_pixels(const Background& background, uint8_t* pixel, int32_t count)
{
    LUMI_TALLY(Work::background, count);
    if constexpr (kKeepsCoverage<Background>) {
        __builtin_memset(pixel, 0, static_cast<uint32_t>(count) * Pixel::kBytes);
    } else {
        const Rgb8 colour = background.template under<Pixel>(nullptr);
#pragma GCC unroll 8
        for (int32_t k = 0; k < count; ++k, pixel += Pixel::kBytes) Pixel::store(pixel, colour);
    }
}

// Writes the background on both sides of a scanline's covered extent, where the background is of the kind that fills:
// never beside the stripe, wherever the extent lies.
template <class Pixel, class Background>
void fill_beside(const Background& background, const Stripe& stripe, const Extent& extent, int32_t y)
{
    if (!Background::kFills) return;
    const auto within = [](int32_t x, int32_t from, int32_t to) { return x < from ? from : x < to ? x : to; };
    const int32_t left = stripe.x_px;
    const int32_t right = stripe.right_px();
    const int32_t begin = within(extent.begin, left, right);
    const int32_t end = within(extent.end, begin, right);
    fill_pixels<Pixel>(background, pixel_of<Pixel>(stripe, left, y), begin - left);
    fill_pixels<Pixel>(background, pixel_of<Pixel>(stripe, end, y), right - end);
}

}  // namespace lumi::detail
