// SPDX-License-Identifier: MIT
// Opaque triangles over samples that hold a pixel in 5, 6 and 5 bits, high byte first.
#include "surface/row_loops.h"

namespace lumi::detail
{

#ifndef LUMI_ROW_LOOPS_IN_ASSEMBLY
LUMI_HOT void lumi_rows_565_swapped_nearest(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565Swapped>, Filter::nearest>(rows);
}

LUMI_HOT void lumi_rows_565_swapped_two_taps(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565Swapped>, Filter::two_taps>(rows);
}
#endif

LUMI_HOT void rows_565_swapped_bilinear(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565Swapped>, Filter::bilinear>(rows);
}

}  // namespace lumi::detail
