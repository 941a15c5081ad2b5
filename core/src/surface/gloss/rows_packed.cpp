// SPDX-License-Identifier: MIT
// Opaque triangles with gloss over samples that hold a PackedColour.
#include "surface/gloss/rows.h"

namespace lumi::detail
{

LUMI_HOT void gloss_rows_packed_nearest(Rows& rows, GlossRows& gloss)
{
    draw_rows<PackedSample, Filter::nearest>(rows, AddedGloss(gloss));
}

LUMI_HOT void gloss_rows_packed_two_taps(Rows& rows, GlossRows& gloss)
{
    draw_rows<PackedSample, Filter::two_taps>(rows, AddedGloss(gloss));
}

LUMI_HOT void gloss_rows_packed_bilinear(Rows& rows, GlossRows& gloss)
{
    draw_rows<PackedSample, Filter::bilinear>(rows, AddedGloss(gloss));
}

}  // namespace lumi::detail
