// SPDX-License-Identifier: MIT
// A colour in one word, so that one addition adds three channels: red in bits 21 .. 31, green in 10 .. 20, blue in
// 0 .. 9. A field is a guard bit, 8 bits of level and a fraction: two bits of red and green, one of blue.
#pragma once

#include "lumi/color.h"
#include "lumi/pixel.h"
#include "lumi/surface/detail/hot.h"

namespace lumi::detail
{

using PackedColour = uint32_t;

inline constexpr uint32_t kGuardBits = 0x80100200;

// Levels times 4, each below 1024.
constexpr PackedColour packed_colour(uint32_t r_q2, uint32_t g_q2, uint32_t b_q2)
{
    return r_q2 << 21 | g_q2 << 10 | b_q2 >> 1;
}

// Differences of levels times 4, of either sign: to be added to a colour. Wraps as the sum does.
constexpr PackedColour packed_difference(int32_t r_q2, int32_t g_q2, int32_t b_q2)
{
    return (static_cast<uint32_t>(r_q2) << 21) + (static_cast<uint32_t>(g_q2) << 10) + static_cast<uint32_t>(b_q2 >> 1);
}

// A sum with some guard bit set: that channel is below 0 (the next bit is set, too) or above the most there is.
LUMI_HOT PackedColour clamped(PackedColour sum);

// The mean of two colours, each channel rounded down.
constexpr PackedColour mean_of(PackedColour a, PackedColour b)
{
    return ((a + b) >> 1) & ~kGuardBits;
}

// The colour of the mean light of four, which is about their levels' squares; `black` is the palette's colour of it.
LUMI_HOT PackedColour mean_light_of(const PackedColour (&c)[4], PackedColour black);

// The mean of a pixel's samples. Where they are within 32 levels of the first one's, the mean of their levels stands
// for that of their light.
inline PackedColour mean_of(PackedColour a, PackedColour b, PackedColour c, PackedColour d, PackedColour black)
{
    constexpr PackedColour kApart = packed_colour(128, 128, 128), kBeyond = 0xE01C0380;  // 0 .. 255 leaves these bits 0
    const PackedColour from = a + kApart;
    if ((((from - b) | (from - c) | (from - d)) & kBeyond) != 0) return mean_light_of({a, b, c, d}, black);
    return mean_of(mean_of(a, b), mean_of(c, d));
}

constexpr Rgb8 unpacked(PackedColour c)
{
    return {static_cast<uint8_t>(c >> 23), static_cast<uint8_t>(c >> 12), static_cast<uint8_t>(c >> 1)};
}

// What a palette's entry becomes for a format of pixels, so that its cut-off bits are a rounding.
template <class Pixel>
constexpr PackedColour palette_colour(const Rgb8& c)
{
    if constexpr (kPacks565<Pixel>) {
        const auto five = [](uint32_t v) { return (v * 4 * 248 + 127) / 255 + 16; };
        const auto six = [](uint32_t v) { return (v * 4 * 252 + 127) / 255 + 8; };
        return packed_colour(five(c.r), six(c.g), five(c.b));
    } else if constexpr (kPacks555<Pixel>) {
        const auto five = [](uint32_t v) { return (v * 4 * 248 + 127) / 255 + 16; };
        return packed_colour(five(c.r), five(c.g), five(c.b));
    } else {
        return packed_colour(4u * c.r + 2, 4u * c.g + 2, 4u * c.b + 2);
    }
}

template <class Pixel>
inline void store_colour(uint8_t* pixel, PackedColour c)
{
    if constexpr (kPacks565<Pixel>)
        Pixel::store_packed(pixel, static_cast<uint16_t>((c >> 15 & 0xF800) | (c >> 9 & 0x07E0) | (c >> 4 & 0x1F)));
    else if constexpr (kPacks555<Pixel>)
        Pixel::store_packed(pixel, static_cast<uint16_t>((c >> 26 & 0x1F) | (c >> 10 & 0x03E0) | (c << 6 & 0x7C00)));
    else
        Pixel::store(pixel, unpacked(c));
}

}  // namespace lumi::detail
