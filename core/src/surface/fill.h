// SPDX-License-Identifier: MIT
// Fills triangles of the grid of samples with depth, texture and colour; the nearest stays.
//
// A sample belongs to a triangle if it lies right of the left edge or on it, left of the right edge, and between the
// scanlines of its ends. All of this is decided exactly on the vertices' grid: triangles that share an edge share
// neither a sample nor leave one out.
#pragma once

#include "lumi/surface/detail/hot.h"
#include "surface/projection.h"

namespace lumi::detail
{

// A rectangle of samples in memory.
struct Target {
    uint16_t* depths;
    PackedColour* colours;
    int32_t x, y, width, height;  // samples; scanlines are `width` apart
    const PackedColour* palette;
    bool has_two_taps;  // a texel is the sum of two, a quarter texel away on either side; the palette has halves
    // Textures that change by no more than so much of a texel a sample are read bilinearly; negative: none.
    int32_t magnified_q10;
};

// A rectangle of texels, see surface/format.h.
struct Texture {
    const uint8_t* texels;
    uint32_t columns, rows;
};

struct Corner {
    SamplePoint point;
    int32_t u_q8, v_q8;  // texels
    uint32_t colour;     // as SurfaceVertex has it
};

// A vertex's share of the colour: 3 signed fields of 10 bits, levels times 4.
inline int32_t red_q2(uint32_t colour)
{
    return static_cast<int32_t>(colour) >> 22;
}
inline int32_t green_q2(uint32_t colour)
{
    return static_cast<int32_t>(colour << 10) >> 22;
}
inline int32_t blue_q2(uint32_t colour)
{
    return static_cast<int32_t>(colour << 20) >> 22;
}

// Fills a triangle at most kSmallQ6 wide and high whose corners are there and lie counter-clockwise on the screen, or
// clockwise, too, where `two_sided`.
LUMI_HOT void fill_triangle(const Corner& a, const Corner& b, const Corner& c, bool two_sided, const Texture& texture,
                            const Target& target);

}  // namespace lumi::detail
