// SPDX-License-Identifier: MIT
// The loops of lumi/surface/detail/rows.h in C++, for every kind of colour and way to read textures, of opaque
// triangles and of see-through ones.
//
// A build may put hot functions into one section (LUMI_HOT_SECTION), of which a linker takes all that one file has or
// nothing. So there is a file for each kind of samples, rows_*.cpp and blends_*.cpp.
#pragma once

#include "lumi/surface/detail/see_through.h"

// Processors for which loops over opaque 5-6-5 pixels exist in assembly (armv6m/rows.S, armv7m/rows.S), which reads
// struct Rows as it is.
#if defined(__ARM_ARCH_6M__) || (defined(__thumb2__) && __ARM_ARCH_PROFILE == 'M')
#define LUMI_ROW_LOOPS_IN_ASSEMBLY 1
#endif

namespace lumi::detail
{

enum class Filter : uint8_t { nearest, two_taps, bilinear };

// Four texels lie around a place; `across` and `down` say how far it is from the first one's middle to the right and
// down, 1/16 texel.
struct FourTexels {
    const uint8_t *upper, *lower;
    uint32_t left, right;
    uint32_t across, down;
};

// Where the place is near the rectangle's rim, the texels beyond it are those at the rim.
LUMI_ALWAYS_INLINE FourTexels texels_around(uint32_t place, const Rows& rows)
{
    const int32_t u = static_cast<int32_t>(place & 0xFFFF) - 512, v = static_cast<int32_t>(place >> 16) - 512;
    const int32_t column = u >> 10, row = v >> 10;
    const uint32_t across = static_cast<uint32_t>(u >> 6) & 15, down = static_cast<uint32_t>(v >> 6) & 15;
    if (static_cast<uint32_t>(column) < rows.columns - 1 && static_cast<uint32_t>(row) < rows.texel_rows - 1) {
        const uint8_t* const first = rows.texels + static_cast<uint32_t>(row) * rows.columns + column;
        return {first, first + rows.columns, 0, 1, across, down};
    }
    const auto within = [](int32_t k, uint32_t count) {
        return k < 0 ? 0u : static_cast<uint32_t>(k) < count ? static_cast<uint32_t>(k) : count - 1;
    };
    return {rows.texels + within(row, rows.texel_rows) * rows.columns,
            rows.texels + within(row + 1, rows.texel_rows) * rows.columns,
            within(column, rows.columns),
            within(column + 1, rows.columns),
            across,
            down};
}

// The texture's colour at a place: of the texel there, the sum of two, or blended between the middles of four by 1/16
// of a texel. Of two taps `place` is the upper left one's.
template <Filter kFilter>
LUMI_ALWAYS_INLINE PackedColour texel(uint32_t place, const Rows& rows)
{
    // v = place / 2^26 and u = place / 2^10 mod 2^6, texels: see Rows.
    const auto tap = [&](uint32_t at) {
        return rows.palette[rows.texels[(at >> 26) * rows.columns + ((at << 16) >> 26)]];
    };
    if constexpr (kFilter == Filter::nearest)
        return tap(place);
    else
        return tap(place) + tap(place + 2 * kQuarter);
}

template <>
LUMI_ALWAYS_INLINE PackedColour texel<Filter::bilinear>(uint32_t place, const Rows& rows)
{
    const FourTexels t = texels_around(place, rows);
    const uint32_t upper_left = t.upper[t.left], upper_right = t.upper[t.right];
    const uint32_t lower_left = t.lower[t.left], lower_right = t.lower[t.right];
    if (((upper_left ^ upper_right) | (upper_left ^ lower_left) | (upper_left ^ lower_right)) == 0)
        return rows.has_two_taps ? rows.palette[upper_left] * 2 : rows.palette[upper_left];
    LUMI_TALLY(Work::mixed_texels, 1);
    const uint32_t both = t.across * t.down, across = 16 * t.across - both, down = 16 * t.down - both;
    uint32_t r = 0, g = 0, b = 0;
    const auto add = [&](uint32_t entry, uint32_t weight) {
        const PackedColour c = rows.palette[entry];
        g += weight * (c >> 21);
        r += weight * ((c >> 10) & 0x3FF);
        b += weight * (c & 0x1FF);
    };
    add(upper_left, 256 - across - down - both);
    add(upper_right, across);
    add(lower_left, down);
    add(lower_right, both);
    const PackedColour mean = (g >> 8) << 21 | (r >> 8) << 10 | b >> 8;
    return rows.has_two_taps ? mean * 2 : mean;
}

// Samples that hold a pixel in 5, 6 and 5 bits.
template <class Pixel>
struct Sample565 {
    static constexpr bool kIsBlended = false;
    using Colour = uint16_t;
    static Colour stored(PackedColour c)
    {
        Colour pixel = 0;
        Pixel::store_packed(reinterpret_cast<uint8_t*>(&pixel), packed_565(c));
        return pixel;
    }
};

// Samples that hold a PackedColour.
struct PackedSample {
    static constexpr bool kIsBlended = false;
    using Colour = PackedColour;
    static PackedColour loaded(Colour c) { return c; }
    static Colour stored(PackedColour c) { return c; }
};

// The sum of two colours whose channels have their guard bits clear, each at most white: min(a + b, white). A field
// that reaches its guard bit, 2^k, is filled by 2^k - 2^(k - 10), of blue 2^k - 2^(k - 9): ones in all bits below it.
LUMI_ALWAYS_INLINE PackedColour saturated_sum(PackedColour a, PackedColour b)
{
    const PackedColour sum = a + b, over = sum & kGuardBits;
    if (over == 0) return sum;
    constexpr PackedColour kUpper = kGuardBits & ~PackedColour{0x200};  // green and red have ten bits, blue has nine
    const PackedColour full = (over & kUpper) - ((over & kUpper) >> 10) + (over & 0x200) - ((over & 0x200) >> 9);
    return (sum | full) & ~kGuardBits;
}

// Whether all light passes by these shares. The sum of two taps is one less than all.
LUMI_ALWAYS_INLINE bool is_all(PackedColour shares)
{
    constexpr PackedColour kLowest = 1u << 21 | 1u << 10 | 1u, kAll = 1023u << 21 | 1023u << 10 | 511u;
    return (shares | kLowest) == kAll;
}

// How clear a sample stays for the background, as coverage_of() reads it from the depth, behind what passes light by
// these shares and shows this colour: clear · (r + 2g + b)/4, where blue has nine bits and so counts twice. What shines
// brighter than it covers counts as covering: at most 1 - the brightest channel.
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

// Samples that hold the same and what see-through triangles are blended over.
struct BlendedPacked : PackedSample {
    static constexpr bool kIsBlended = true;
};

template <class Pixel, bool kIsSwapped>
struct Blended565 : Sample565<Pixel> {
    static constexpr bool kIsBlended = true;
    // In the middle of the levels that become this pixel.
    static PackedColour loaded(uint16_t pixel)
    {
        const uint16_t v = kIsSwapped ? __builtin_bswap16(pixel) : pixel;
        return (apart(v).word << 4) + palette_colour<Pixel>({0, 0, 0});
    }
};

// A loop's samples; its shown ones come next.
template <class Sample, Filter kFilter>
constexpr Work work_of_samples()
{
    constexpr uint32_t kNth = static_cast<uint32_t>(kFilter);
    if (Sample::kIsBlended) return nth_work(Work::see_sample, 2 * kNth);
    if (kFilter == Filter::bilinear) return Work::bilinear_sample;
    return sizeof(typename Sample::Colour) == sizeof(PackedColour) ? Work::packed_sample
                                                                   : nth_work(Work::sample, 2 * kNth);
}

// Rows without gloss.
struct NoGloss {
    struct Row {
        PackedColour over(PackedColour colour) const { return colour; }
        void go_right() {}
    };
    Row row_at(uint32_t) const { return {}; }
    void go_down() {}
};

// Draws every row. Sample: what a sample holds, `Colour`, and how a PackedColour becomes that, `stored()`; where
// triangles are blended over samples, also how it is read, `loaded()`.
template <class Sample, Filter kFilter, class Gloss = NoGloss>
LUMI_ALWAYS_INLINE void draw_rows(Rows& rows, Gloss gloss = {})
{
    // The first sample's quantities are given.
    const auto draw_row =
        [](uint16_t * depth_at, const uint16_t* end, typename Sample::Colour* colour_at, uint32_t depth, uint32_t place,
           PackedColour colour, const Rows& state, auto mirrored) __attribute__((always_inline))
    {
        const Rows at = state;  // none of it changes when a colour is stored
        Rows passing = at;
        if constexpr (Sample::kIsBlended) passing.palette += format::kPaletteEntries;
        do {
            if (depth >> 16 > *depth_at) {
                LUMI_TALLY((nth_work(work_of_samples<Sample, kFilter>(), 1)), 1);
                if constexpr (!Sample::kIsBlended) *depth_at = static_cast<uint16_t>(depth >> 16);
                PackedColour sum = colour + texel<kFilter>(place, at);
                if ((sum & kGuardBits) != 0) sum = clamped(sum);
                sum = mirrored.over(sum);
                if constexpr (Sample::kIsBlended) {
                    const PackedColour passed = texel<kFilter>(place, passing);
                    if (sum != 0 || !is_all(passed)) {
                        sum = saturated_sum(sum, share_of(passed, Sample::loaded(*colour_at)));
                        *colour_at = Sample::stored(sum);
                        LUMI_TALLY(Work::see_alone, *depth_at < kFarDepth);
                        if (*depth_at < kFarDepth) *depth_at = depth_behind(*depth_at, passed, sum);
                    }
                } else {
                    *colour_at = Sample::stored(sum);
                }
            }
            depth += at.depth_right;
            place += at.place_right;
            colour += at.colour_right;
            mirrored.go_right();
            ++colour_at;
        } while (++depth_at != end);
    };
    while (true) {
        LUMI_TALLY(Work::row, 1);
        const int32_t first = rows.edge_q16[0] >> 16, last = rows.edge_q16[1] >> 16;
        if (first < last) {
            LUMI_TALLY(Work::filled, 1);
            LUMI_TALLY((work_of_samples<Sample, kFilter>()), last - first);
            const uint32_t column = static_cast<uint32_t>(first);
            uint16_t* const depths = reinterpret_cast<uint16_t*>(rows.row);
            auto* const colours = reinterpret_cast<typename Sample::Colour*>(rows.row + rows.colours_at);
            draw_row(depths + first, depths + last, colours + first, rows.depth + column * rows.depth_right,
                     rows.place + column * rows.place_right, rows.colour + column * rows.colour_right, rows,
                     gloss.row_at(column));
        }
        rows.edge_q16[0] += rows.edge_step_q16[0];
        rows.edge_q16[1] += rows.edge_step_q16[1];
        rows.depth += rows.depth_down;
        rows.place += rows.place_down;
        rows.colour += rows.colour_down;
        gloss.go_down();
        rows.row += rows.row_bytes;
        if (--rows.count != 0) continue;
        if (rows.count_below == 0) return;
        rows.count = rows.count_below;
        rows.count_below = 0;
        rows.bend();
    }
}

}  // namespace lumi::detail
