// SPDX-License-Identifier: MIT
// The loops of lumi/surface/detail/row_loops.h in C++, for every kind of colour and way to read textures.
#pragma once

#include "lumi/surface/detail/row_loops.h"

namespace lumi::detail
{

enum class Filter : uint8_t { nearest, two_taps, bilinear };

// Four texels around a place, and how far it is from the first one's middle to the right and down, 1/16 texel.
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

// Between the middles of four texels of a rectangle, by 1/16 of a texel.
LUMI_ALWAYS_INLINE PackedColour bilinear_texel(uint32_t place, const Rows& rows)
{
    const FourTexels t = texels_around(place, rows);
    const uint32_t upper_left = t.upper[t.left], upper_right = t.upper[t.right];
    const uint32_t lower_left = t.lower[t.left], lower_right = t.lower[t.right];
    if (((upper_left ^ upper_right) | (upper_left ^ lower_left) | (upper_left ^ lower_right)) == 0)
        return rows.has_two_taps ? rows.palette[upper_left] * 2 : rows.palette[upper_left];
    const uint32_t both = t.across * t.down, across = 16 * t.across - both, down = 16 * t.down - both;
    uint32_t r = 0, g = 0, b = 0;
    const auto add = [&](uint32_t texel, uint32_t weight) {
        const PackedColour c = rows.palette[texel];
        g += weight * (c >> 21);
        r += weight * ((c >> 10) & 0x3FF);
        b += weight * (c & 0x1FF);
    };
    add(upper_left, 256 - across - down - both);
    add(upper_right, across);
    add(lower_left, down);
    add(lower_right, both);
    const PackedColour texel = (g >> 8) << 21 | (r >> 8) << 10 | b >> 8;
    return rows.has_two_taps ? texel * 2 : texel;
}

LUMI_ALWAYS_INLINE PackedColour texel_at(uint32_t place, const Rows& rows)
{
    return rows.palette[rows.texels[(place >> 26) * rows.columns + ((place << 16) >> 26)]];
}

// Of two taps `place` is the upper left one's.
template <Filter kFilter>
LUMI_ALWAYS_INLINE PackedColour filtered(uint32_t place, const Rows& rows)
{
    if constexpr (kFilter == Filter::nearest)
        return texel_at(place, rows);
    else if constexpr (kFilter == Filter::two_taps)
        return texel_at(place, rows) + texel_at(place + 2 * kQuarter, rows);
    else
        return bilinear_texel(place, rows);
}

// Samples that hold a pixel in 5, 6 and 5 bits.
template <class Pixel>
struct Sample565 {
    using Colour = uint16_t;
    static Colour stored(PackedColour c)
    {
        Colour pixel = 0;
        Pixel::store_packed(reinterpret_cast<uint8_t*>(&pixel), packed_565(c));
        return pixel;
    }
};

// Draws the samples of a row from `depth_at` to `end`, whose first quantities are given. Sample: how a colour is
// stored, `Colour` and stored().
template <class Sample, Filter kFilter>
LUMI_ALWAYS_INLINE void draw_samples(uint16_t* depth_at, const uint16_t* end, typename Sample::Colour* colour_at,
                                     uint32_t depth, uint32_t place, PackedColour colour, const Rows& state)
{
    const Rows rows = state;  // none of it changes when a colour is stored
    do {
        if (depth >> 16 > *depth_at) {
            *depth_at = static_cast<uint16_t>(depth >> 16);
            PackedColour sum = colour + filtered<kFilter>(place, rows);
            if ((sum & kGuardBits) != 0) sum = clamped(sum);
            *colour_at = Sample::stored(sum);
        }
        depth += rows.depth_right;
        place += rows.place_right;
        colour += rows.colour_right;
        ++colour_at;
    } while (++depth_at != end);
}

template <class Sample, Filter kFilter, auto kDrawSamples = draw_samples<Sample, kFilter>>
LUMI_ALWAYS_INLINE void draw_rows(Rows& rows)
{
    while (true) {
        const int32_t first = rows.edge_q16[0] >> 16, last = rows.edge_q16[1] >> 16;
        if (first < last) {
            const uint32_t column = static_cast<uint32_t>(first);
            uint16_t* const depths = reinterpret_cast<uint16_t*>(rows.row);
            auto* const colours = reinterpret_cast<typename Sample::Colour*>(rows.row + rows.colours_at);
            kDrawSamples(depths + first, depths + last, colours + first, rows.depth + column * rows.depth_right,
                         rows.place + column * rows.place_right, rows.colour + column * rows.colour_right, rows);
        }
        rows.edge_q16[0] += rows.edge_step_q16[0];
        rows.edge_q16[1] += rows.edge_step_q16[1];
        rows.depth += rows.depth_down;
        rows.place += rows.place_down;
        rows.colour += rows.colour_down;
        rows.row += rows.row_bytes;
        if (--rows.count != 0) continue;
        if (rows.count_below == 0) return;
        rows.count = rows.count_below;
        rows.count_below = 0;
        rows.edge_q16[rows.bent_edge] = rows.below.x_q16;
        rows.edge_step_q16[rows.bent_edge] = rows.below.step_q16;
    }
}

}  // namespace lumi::detail
