// SPDX-License-Identifier: MIT
// Loops over the samples of a triangle's rows: one for each kind of colour and each way to read textures. Each exists
// in C++ (src/surface/row_loops.h); those for 5-6-5 pixels also in assembly, for Armv6-M and for Armv7-M and
// later.
//
// A firmware links those that it names.
#pragma once

#include "lumi/surface/detail/target.h"

namespace lumi::detail
{

// Each of two taps lies so far from the middle; a little less than a quarter texel, so that no rounding leaves the
// rectangle.
inline constexpr uint32_t kQuarter = 200 << 16 | 200;

// Where an edge crosses a row, samples, and by how much more the next.
struct EdgeWalk {
    int32_t x_q16, step_q16;
};

// A triangle's rows: the next one and what it takes to go on. A row's samples are those from the left edge up to the
// right one, both rounded down to a column. Quantities are affine, modulo 2^32, and given for the sample in column 0.
// `place` is that of the upper left one of two taps. Assembly reads this by its offsets.
struct Rows {
    int32_t edge_q16[2];  // left, right
    int32_t edge_step_q16[2];
    // `depth` is Q16; `place` has v in its upper half and u in its lower, UQ6.10 each; `colour` is a PackedColour.
    uint32_t depth, place, colour;
    uint32_t depth_right, place_right, colour_right;  // what a sample adds
    uint32_t depth_down, place_down, colour_down;     // what a row adds
    uint8_t* row;                                     // its first depth
    const uint8_t* texels;
    uint32_t columns;  // of the rectangle of texels
    const PackedColour* palette;
    uint32_t row_bytes, colours_at;  // of Target
    int32_t count;                   // rows, at least one
    int32_t count_below;             // rows after these
    uint32_t bent_edge;              // for which `below` takes the place of this edge
    EdgeWalk below;
    uint32_t texel_rows;
    bool has_two_taps;  // the palette has halves

    // From the next row on `below` is an edge.
    void bend()
    {
        edge_q16[bent_edge] = below.x_q16;
        edge_step_q16[bent_edge] = below.step_q16;
    }
};

// Draws the rows, and leaves `rows` at the one after them.
using DrawRows = void (*)(Rows& rows);

extern "C" {
// These draw 5-6-5 pixels, and the same with their bytes swapped.
void lumi_rows_565_nearest(Rows& rows);
void lumi_rows_565_two_taps(Rows& rows);
void lumi_rows_565_swapped_nearest(Rows& rows);
void lumi_rows_565_swapped_two_taps(Rows& rows);
}
LUMI_HOT void rows_565_bilinear(Rows& rows);
LUMI_HOT void rows_565_swapped_bilinear(Rows& rows);
// PackedColour.
LUMI_HOT void rows_packed_nearest(Rows& rows);
LUMI_HOT void rows_packed_two_taps(Rows& rows);
LUMI_HOT void rows_packed_bilinear(Rows& rows);
// These blend see-through triangles, whose palette is see_through_palette(), over what samples hold.
LUMI_HOT void blend_565_nearest(Rows& rows);
LUMI_HOT void blend_565_two_taps(Rows& rows);
LUMI_HOT void blend_565_bilinear(Rows& rows);
LUMI_HOT void blend_565_swapped_nearest(Rows& rows);
LUMI_HOT void blend_565_swapped_two_taps(Rows& rows);
LUMI_HOT void blend_565_swapped_bilinear(Rows& rows);
LUMI_HOT void blend_packed_nearest(Rows& rows);
LUMI_HOT void blend_packed_two_taps(Rows& rows);
LUMI_HOT void blend_packed_bilinear(Rows& rows);

// Nearest texel, two taps, four texels, for samples that hold a kind of pixel.
struct RowFilters {
    DrawRows nearest, two_taps, bilinear;
};

template <class Pixel>
inline constexpr RowFilters kPixelRows = {};
template <>
inline constexpr RowFilters kPixelRows<PixelRgb565> = {lumi_rows_565_nearest, lumi_rows_565_two_taps,
                                                       rows_565_bilinear};
template <>
inline constexpr RowFilters kPixelRows<PixelRgb565Swapped> = {
    lumi_rows_565_swapped_nearest, lumi_rows_565_swapped_two_taps, rows_565_swapped_bilinear};
inline constexpr RowFilters kPackedRows = {rows_packed_nearest, rows_packed_two_taps, rows_packed_bilinear};

template <class Pixel>
inline constexpr RowFilters kPixelBlends = {};
template <>
inline constexpr RowFilters kPixelBlends<PixelRgb565> = {blend_565_nearest, blend_565_two_taps, blend_565_bilinear};
template <>
inline constexpr RowFilters kPixelBlends<PixelRgb565Swapped> = {blend_565_swapped_nearest, blend_565_swapped_two_taps,
                                                                blend_565_swapped_bilinear};
inline constexpr RowFilters kPackedBlends = {blend_packed_nearest, blend_packed_two_taps, blend_packed_bilinear};

}  // namespace lumi::detail
