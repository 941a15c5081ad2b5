// SPDX-License-Identifier: MIT
// The loops of lumi/surface/detail/see_through.h, for every kind of colour and each way to read textures.
#pragma once

#include "lumi/surface/detail/see_through_samples.h"
#include "surface/rows/row_loops.h"

namespace lumi::detail
{

// The sum of two colours whose channels have their guard bits clear, each at most white.
LUMI_ALWAYS_INLINE PackedColour saturated_sum(PackedColour a, PackedColour b)
{
    const PackedColour sum = a + b, over = sum & kGuardBits;
    if (over == 0) return sum;
    constexpr PackedColour kUpper = kGuardBits & ~PackedColour{0x200};  // green and red have ten bits, blue has nine
    const PackedColour full = (over & kUpper) - ((over & kUpper) >> 10) + (over & 0x200) - ((over & 0x200) >> 9);
    return (sum | full) & ~kGuardBits;
}

// How clear a sample stays for the background, as coverage_of() reads it from the depth, behind what passes light by
// these shares and shows this colour. What shines brighter than it covers counts as covering.
LUMI_ALWAYS_INLINE uint16_t depth_behind(uint32_t depth, PackedColour shares, PackedColour shown)
{
    const uint32_t g = shares >> 21, r = (shares >> 10) & 0x3FF, b = shares & 0x1FF;
    const uint32_t mean = ((r + 2 * g + 2 * b) >> 2) + 1;  // 1/1024
    const uint32_t clear = depth < kShownDepth ? kMostClear : kFarDepth - 1 - depth;
    const uint32_t passed = (clear * mean + 512) >> 10;
    const uint32_t green = shown >> 26, red = (shown >> 15) & 31, blue = (shown >> 4) & 31;
    const uint32_t brighter = red > blue ? red : blue, brightest = green > brighter ? green : brighter;  // of 31
    const uint32_t most = quotient<31, kMostClear * 31>(kMostClear * (31 - brightest));
    return static_cast<uint16_t>(kFarDepth - 1 - (passed < most ? passed : most));
}

struct BlendedPacked {
    using Colour = PackedColour;
    static PackedColour loaded(Colour c) { return c; }
    static Colour stored(PackedColour c) { return c; }
};

template <class Pixel, bool kIsSwapped>
struct Blended565 : Sample565<Pixel> {
    // In the middle of the levels that become this pixel.
    static PackedColour loaded(uint16_t pixel)
    {
        const uint16_t v = kIsSwapped ? __builtin_bswap16(pixel) : pixel;
        return (apart(v).word << 4) + palette_colour<Pixel>({0, 0, 0});
    }
};

template <class Sample, Filter kFilter>
LUMI_ALWAYS_INLINE void blend_samples(uint16_t* depth_at, const uint16_t* end, typename Sample::Colour* colour_at,
                                      uint32_t depth, uint32_t place, PackedColour colour, const Rows& state)
{
    const Rows rows = state;  // none of it changes when a colour is stored
    Rows of_passed = rows;
    of_passed.palette += format::kPaletteEntries;
    do {
        if (depth >> 16 > *depth_at) {
            PackedColour added = colour + filtered<kFilter>(place, rows);
            if ((added & kGuardBits) != 0) added = clamped(added);
            const PackedColour passed = filtered<kFilter>(place, of_passed);
            const PackedColour sum = saturated_sum(added, share_of(passed, Sample::loaded(*colour_at)));
            *colour_at = Sample::stored(sum);
            if (*depth_at < kFarDepth) *depth_at = depth_behind(*depth_at, passed, sum);
        }
        depth += rows.depth_right;
        place += rows.place_right;
        colour += rows.colour_right;
        ++colour_at;
    } while (++depth_at != end);
}

template <class Sample, Filter kFilter>
LUMI_ALWAYS_INLINE void blend_rows(Rows& rows)
{
    draw_rows<Sample, kFilter, blend_samples<Sample, kFilter>>(rows);
}

}  // namespace lumi::detail
