// SPDX-License-Identifier: MIT
// Wide triangles, see WideTriangle.
#pragma once

#include "lumi/surface/detail/pieces.h"

namespace lumi::detail
{

// What colour may lose from one side of a triangle to the other, levels: nothing in the middle, and half of it at
// either end. In triangles of less than kWideQ6 samples it never loses more, for blue, which loses most, loses at most
// a quarter level a sample.
inline constexpr int32_t kMostLostQ24 = 6 << 24, kWideQ6 = kMostLostQ24 >> 16;

// Begins with the first part. `wide` holds what is lost; `long_step_q16` is the step of the edge from the upper end to
// the lower one, and `frame_row` that of the piece's first row.
void begin_wide(TrianglePiece& piece, int32_t long_step_q16, int32_t frame_row);

// Makes the piece the next part, after rows have been drawn; false after the last, and then it is not wide any more.
LUMI_HOT bool next_part_of_wide(TrianglePiece& piece);

}  // namespace lumi::detail
