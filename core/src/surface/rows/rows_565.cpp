// SPDX-License-Identifier: MIT
// Samples that hold a pixel in 5, 6 and 5 bits, low byte first.
#include "surface/rows/row_loops.h"
#include "surface/rows/row_loops_in_assembly.h"

namespace lumi::detail
{

LUMI_HOT void rows_565_bilinear(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565>, Filter::bilinear>(rows);
}

#ifndef LUMI_ROW_LOOPS_IN_ASSEMBLY
LUMI_HOT void lumi_rows_565_nearest(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565>, Filter::nearest>(rows);
}

LUMI_HOT void lumi_rows_565_two_taps(Rows& rows)
{
    draw_rows<Sample565<PixelRgb565>, Filter::two_taps>(rows);
}
#endif

}  // namespace lumi::detail
