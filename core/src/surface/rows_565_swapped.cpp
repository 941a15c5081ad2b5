// SPDX-License-Identifier: MIT
// Samples that hold a pixel in 5, 6 and 5 bits, high byte first.
#include "surface/row_loops.h"
#include "surface/row_loops_in_assembly.h"

namespace lumi::detail
{

LUMI_HOT void rows_565_swapped_bilinear(Rows& rows, int32_t count)
{
    draw_rows<Sample565<PixelRgb565Swapped>, Filter::bilinear>(rows, count);
}

#ifndef LUMI_ROW_LOOPS_IN_ASSEMBLY
LUMI_HOT void lumi_rows_565_swapped_nearest(Rows& rows, int32_t count)
{
    draw_rows<Sample565<PixelRgb565Swapped>, Filter::nearest>(rows, count);
}

LUMI_HOT void lumi_rows_565_swapped_two_taps(Rows& rows, int32_t count)
{
    draw_rows<Sample565<PixelRgb565Swapped>, Filter::two_taps>(rows, count);
}
#endif

}  // namespace lumi::detail
