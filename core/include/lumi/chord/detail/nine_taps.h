// SPDX-License-Identifier: MIT
// Nine taps of a pixel: three texels of three origins.
#pragma once

#include "lumi/chord/detail/sums.h"

namespace lumi::detail
{

// Rows of three origins, the same three texels of each, weights as Sum takes them.
struct PixelTaps {
    const uint8_t* row[3];
    int32_t offset[2];  // where the second and third texel are
    uint32_t row_weight[3], weight[3];
};

template <class Sum>
LUMI_ALWAYS_INLINE Sum sum_of(const Field& field, const PixelTaps& taps)
{
    Sum sum;
#pragma GCC unroll 3
    for (int m = 0; m < 3; ++m) {
        const uint8_t* row = settled(taps.row[m]);
        typename Sum::Row of_row;
        of_row.add(field, row, taps.weight[0]);
        of_row.add(field, row + taps.offset[0], taps.weight[1]);
        of_row.add(field, row + taps.offset[1], taps.weight[2]);
        sum.add(of_row, taps.row_weight[m]);
    }
    return sum;
}

}  // namespace lumi::detail
