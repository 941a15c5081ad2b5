// SPDX-License-Identifier: MIT
// See-through triangles over samples that hold a PackedColour.
#include "surface/row_loops.h"

namespace lumi::detail
{

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
