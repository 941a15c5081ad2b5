// SPDX-License-Identifier: MIT
// See-through triangles over samples that hold a pixel in 5, 6 and 5 bits, high byte first.
#include "surface/row_loops.h"

namespace lumi::detail
{

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

}  // namespace lumi::detail
