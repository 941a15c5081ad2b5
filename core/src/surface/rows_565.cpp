// SPDX-License-Identifier: MIT
// Opaque triangles over samples that hold a pixel in 5, 6 and 5 bits, low byte first.
#include <stddef.h>

#include "surface/row_loops.h"

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
#endif

LUMI_HOT void rows_565_bilinear(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565>, Filter::bilinear>(rows);
}

}  // namespace lumi::detail
