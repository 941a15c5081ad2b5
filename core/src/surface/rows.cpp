// SPDX-License-Identifier: MIT
// The loops over rows, by name: those that a firmware does not name are not linked.
#include <stddef.h>

#include "surface/row_loops.h"

// Processors for which loops over 5-6-5 pixels exist in assembly (armv6m/rows.S, armv7m/rows.S), which reads struct
// Rows as it is.
#if defined(__ARM_ARCH_6M__) || (defined(__thumb2__) && __ARM_ARCH_PROFILE == 'M')
#define LUMI_ROW_LOOPS_IN_ASSEMBLY 1
#endif

namespace lumi::detail
{

#ifdef LUMI_ROW_LOOPS_IN_ASSEMBLY
static_assert(offsetof(Rows, edge_q16) == 0 && offsetof(Rows, edge_step_q16) == 8, "EDGES, STEPS of rows.inc");
static_assert(offsetof(Rows, depth) == 16 && offsetof(Rows, place) == 20 && offsetof(Rows, colour) == 24, "QUANTITIES");
static_assert(offsetof(Rows, depth_right) == 28 && offsetof(Rows, colour_right) == 36, "RIGHT");
static_assert(offsetof(Rows, depth_down) == 40 && offsetof(Rows, colour_down) == 48, "DOWN");
static_assert(offsetof(Rows, row) == 52, "ROW");
static_assert(offsetof(Rows, texels) == 56 && offsetof(Rows, columns) == 60 && offsetof(Rows, palette) == 64, "TEXELS");
static_assert(offsetof(Rows, row_bytes) == 68 && offsetof(Rows, colours_at) == 72, "ROW_BYTES, COLOURS_AT");
static_assert(offsetof(Rows, count) == 76 && offsetof(Rows, count_below) == 80, "COUNT, COUNT_BELOW");
static_assert(offsetof(Rows, bent_edge) == 84 && offsetof(Rows, below) == 88, "BENT_EDGE");
static_assert(2 * kQuarter == (400u << 16 | 400u), "TAPS_APART");
static_assert(kGuardBits == 0x80100200, "GUARD_BITS");
#else
LUMI_HOT void lumi_rows_565_nearest(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565>, Filter::nearest>(rows);
}

LUMI_HOT void lumi_rows_565_two_taps(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565>, Filter::two_taps>(rows);
}

LUMI_HOT void lumi_rows_565_swapped_nearest(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565Swapped>, Filter::nearest>(rows);
}

LUMI_HOT void lumi_rows_565_swapped_two_taps(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565Swapped>, Filter::two_taps>(rows);
}
#endif

LUMI_HOT void rows_565_bilinear(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565>, Filter::bilinear>(rows);
}

LUMI_HOT void rows_565_swapped_bilinear(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565Swapped>, Filter::bilinear>(rows);
}

LUMI_HOT void rows_packed_nearest(Rows& rows)
{
    draw_rows<PackedSample, Filter::nearest>(rows);
}

LUMI_HOT void rows_packed_two_taps(Rows& rows)
{
    draw_rows<PackedSample, Filter::two_taps>(rows);
}

LUMI_HOT void rows_packed_bilinear(Rows& rows)
{
    draw_rows<PackedSample, Filter::bilinear>(rows);
}

LUMI_HOT void blend_565_nearest(Rows& rows)
{
    draw_rows<Blended565<PixelRgb565, false>, Filter::nearest>(rows);
}

LUMI_HOT void blend_565_two_taps(Rows& rows)
{
    draw_rows<Blended565<PixelRgb565, false>, Filter::two_taps>(rows);
}

LUMI_HOT void blend_565_bilinear(Rows& rows)
{
    draw_rows<Blended565<PixelRgb565, false>, Filter::bilinear>(rows);
}

LUMI_HOT void blend_565_swapped_nearest(Rows& rows)
{
    draw_rows<Blended565<PixelRgb565Swapped, true>, Filter::nearest>(rows);
}

LUMI_HOT void blend_565_swapped_two_taps(Rows& rows)
{
    draw_rows<Blended565<PixelRgb565Swapped, true>, Filter::two_taps>(rows);
}

LUMI_HOT void blend_565_swapped_bilinear(Rows& rows)
{
    draw_rows<Blended565<PixelRgb565Swapped, true>, Filter::bilinear>(rows);
}

LUMI_HOT void blend_packed_nearest(Rows& rows)
{
    draw_rows<BlendedPacked, Filter::nearest>(rows);
}

LUMI_HOT void blend_packed_two_taps(Rows& rows)
{
    draw_rows<BlendedPacked, Filter::two_taps>(rows);
}

LUMI_HOT void blend_packed_bilinear(Rows& rows)
{
    draw_rows<BlendedPacked, Filter::bilinear>(rows);
}

}  // namespace lumi::detail
