// SPDX-License-Identifier: MIT
// See-through triangles over samples that hold a pixel in 5, 6 and 5 bits, low byte first.
#include "surface/see_through_rows.h"

namespace lumi::detail
{

LUMI_HOT void blend_565_nearest(Rows& rows, int32_t count)
{
    blend_rows<Blended565<PixelRgb565, false>, Filter::nearest>(rows, count);
}

LUMI_HOT void blend_565_two_taps(Rows& rows, int32_t count)
{
    blend_rows<Blended565<PixelRgb565, false>, Filter::two_taps>(rows, count);
}

LUMI_HOT void blend_565_bilinear(Rows& rows, int32_t count)
{
    blend_rows<Blended565<PixelRgb565, false>, Filter::bilinear>(rows, count);
}

}  // namespace lumi::detail
