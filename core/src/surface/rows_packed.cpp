// SPDX-License-Identifier: MIT
// Opaque triangles over samples that hold a PackedColour.
#include "surface/row_loops.h"

namespace lumi::detail
{

LUMI_HOT void rows_packed_nearest(Rows& rows)
{
    draw_rows<PackedSample, Filter::nearest>(rows);
}

LUMI_HOT void rows_packed_two_taps(Rows& rows)
{
    draw_rows<PackedSample, Filter::two_taps>(rows);
}

LUMI_HOT void rows_packed_bilinear(Rows& rows)
{
    draw_rows<PackedSample, Filter::bilinear>(rows);
}

}  // namespace lumi::detail
