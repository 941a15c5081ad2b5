// SPDX-License-Identifier: MIT
// Opaque triangles with gloss over samples that hold a pixel in 5, 6 and 5 bits, high byte first.
#include "surface/gloss/rows.h"

namespace lumi::detail
{

LUMI_HOT void gloss_rows_565_swapped_nearest(Rows& rows, GlossRows& gloss)
{
    draw_rows<Sample565<PixelRgb565Swapped>, Filter::nearest>(rows, AddedGloss(gloss));
}

LUMI_HOT void gloss_rows_565_swapped_two_taps(Rows& rows, GlossRows& gloss)
{
    draw_rows<Sample565<PixelRgb565Swapped>, Filter::two_taps>(rows, AddedGloss(gloss));
}

LUMI_HOT void gloss_rows_565_swapped_bilinear(Rows& rows, GlossRows& gloss)
{
    draw_rows<Sample565<PixelRgb565Swapped>, Filter::bilinear>(rows, AddedGloss(gloss));
}

}  // namespace lumi::detail
