// SPDX-License-Identifier: MIT
// A colour in one word, so that one addition adds three channels: green in bits 21 .. 31, red in 10 .. 20, blue in
// 0 .. 9. A field is a guard bit, 8 bits of level and a fraction: two bits of green and red, one of blue. The upper
// bits of the fields, shifted right by 4, are the channels of RGB565 in the two halves of a word.
#pragma once

#include "lumi/color.h"
#include "lumi/detail/compiler.h"
#include "lumi/detail/math.h"
#include "lumi/pixel.h"

namespace lumi::detail
{

using PackedColour = uint32_t;

inline constexpr PackedColour kGuardBits = 0x80100200;

// Takes levels times 4, each below 1024.
constexpr PackedColour packed_colour(uint32_t r_q2, uint32_t g_q2, uint32_t b_q2)
{
    return g_q2 << 21 | r_q2 << 10 | b_q2 >> 1;
}

// A sum with some guard bit set: that channel is below 0 (the next bit is set, too) or above the most there is.
// Assembly calls it by this name.
extern "C" LUMI_HOT PackedColour lumi_clamped(PackedColour sum);
inline PackedColour clamped(PackedColour sum)
{
    return lumi_clamped(sum);
}

// The mean of two colours, each channel rounded down: the sum halved, without the bit that each field's lowest one
// leaves in the guard bit below.
constexpr PackedColour mean_of(PackedColour a, PackedColour b)
{
    return ((a + b) >> 1) & ~kGuardBits;
}

// The colour of the mean light of four, which is about their levels' squares; `black` is the palette's colour of it.
LUMI_HOT PackedColour mean_light_of(const PackedColour (&c)[4], PackedColour black);

// Whether some of four colours is more than 32 levels from the first one. In levels, each channel of a + 32 - b lies in
// [0, 64) unless they are apart, so that a bit of 64 or more, or those of a negative number, tell it.
constexpr bool are_apart(PackedColour a, PackedColour b, PackedColour c, PackedColour d)
{
    constexpr PackedColour kApart = packed_colour(128, 128, 128), kBeyond = 0xE01C0380;  // 0 .. 255 leaves these bits 0
    const PackedColour from = a + kApart;
    return (((from - b) | (from - c) | (from - d)) & kBeyond) != 0;
}

// The mean of a pixel's samples. Where they are within 32 levels of the first one's, the mean of their levels stands
// for that of their light.
inline PackedColour mean_of(PackedColour a, PackedColour b, PackedColour c, PackedColour d, PackedColour black)
{
    if (are_apart(a, b, c, d)) return mean_light_of({a, b, c, d}, black);
    return mean_of(mean_of(a, b), mean_of(c, d));
}

constexpr Rgb8 unpacked(PackedColour c)
{
    return {static_cast<uint8_t>(c >> 12), static_cast<uint8_t>(c >> 23), static_cast<uint8_t>(c >> 1)};
}

// Packs a palette's entry for a format of pixels, so that cutting off its lower bits is a rounding.
template <class Pixel>
constexpr PackedColour palette_colour(const Rgb8& c)
{
    // 4v · 248/255 and 4v · 252/255, rounded.
    const auto five = [](uint32_t v) { return 4 * v - quotient<255, 28 * 255 + 127>(28 * v + 127) + 16; };
    if constexpr (kPacks565<Pixel>) {
        const auto six = [](uint32_t v) { return 4 * v - quotient<255, 12 * 255 + 127>(12 * v + 127) + 8; };
        return packed_colour(five(c.r), six(c.g), five(c.b));
    } else if constexpr (kPacks555<Pixel>) {
        return packed_colour(five(c.r), five(c.g), five(c.b));
    } else {
        return packed_colour(4u * c.r + 2, 4u * c.g + 2, 4u * c.b + 2);
    }
}

// Holds the channels of a pixel in 5, 6 and 5 bits with room above each: green in the upper half of a word.
inline constexpr uint32_t kFields565 = 0x07E0F81F;
struct Fields565 {
    uint32_t word;
};
constexpr Fields565 apart(uint16_t pixel)
{
    return {(pixel | static_cast<uint32_t>(pixel) << 16) & kFields565};
}
constexpr uint16_t together(Fields565 f)
{
    return static_cast<uint16_t>(f.word | f.word >> 16);
}

constexpr Rgb8 levels_of(Fields565 f)
{
    return unpack_rgb565(together(f));
}
constexpr Rgb8 levels_of(const Rgb8& c)
{
    return c;
}

// Returns the 16 bits of a colour in 5, 6 and 5 bits.
LUMI_ALWAYS_INLINE uint16_t packed_565(PackedColour c)
{
    return together({(c >> 4) & kFields565});
}

// Returns them in 5 bits each, blue above.
LUMI_ALWAYS_INLINE uint16_t packed_555(PackedColour c)
{
    return static_cast<uint16_t>((c >> 15 & 0x1F) | (c >> 21 & 0x03E0) | (c << 6 & 0x7C00));
}

template <class Pixel>
inline void store_colour(uint8_t* pixel, PackedColour c)
{
    if constexpr (kPacks565<Pixel>)
        Pixel::store_packed(pixel, packed_565(c));
    else if constexpr (kPacks555<Pixel>)
        Pixel::store_packed(pixel, packed_555(c));
    else
        Pixel::store(pixel, unpacked(c));
}

// Returns share·c of each channel. Shares are in 1/1024, less one of them so that ten bits hold it; those of blue are
// in 1/512.
LUMI_ALWAYS_INLINE PackedColour share_of(PackedColour shares, PackedColour c)
{
    const uint32_t g = ((shares >> 21) + 1) * (c >> 21) >> 10;
    const uint32_t r = (((shares >> 10) & 0x3FF) + 1) * ((c >> 10) & 0x3FF) >> 10;
    const uint32_t b = ((shares & 0x1FF) + 1) * (c & 0x1FF) >> 9;
    return g << 21 | r << 10 | b;
}

// How much of what lies behind passes, 0 .. 255 a channel, as share_of() takes it.
constexpr PackedColour packed_shares(const uint8_t* passed)
{
    // v · 1023/255 and v · 511/255, rounded.
    const auto ten = [](uint32_t v) { return 4 * v + quotient<255, 3 * 255 + 127>(3 * v + 127); };
    const auto nine = [](uint32_t v) { return 2 * v + quotient<255, 255 + 127>(v + 127); };
    return ten(passed[1]) << 21 | ten(passed[0]) << 10 | nine(passed[2]);
}

}  // namespace lumi::detail
