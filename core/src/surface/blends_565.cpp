// SPDX-License-Identifier: MIT
// See-through triangles over samples that hold a pixel in 5, 6 and 5 bits, low byte first.
#include "surface/row_loops.h"

namespace lumi::detail
{

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

}  // namespace lumi::detail
