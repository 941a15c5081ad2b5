// SPDX-License-Identifier: MIT
// Reciprocal, root and angle of 16-bit accuracy from 32×32→32 products, for what is evaluated every few pixels: small
// tables with linear interpolation (0.8 KB). math.h has the exact ones.
#pragma once

#include <stdint.h>

namespace lumi::detail
{

// The angle of (x, y) from +x towards +y, of 16-bit components; 0 for (0, 0). Error below 2^-16 turn.
uint32_t coarse_angle_turns32(int32_t y_q15, int32_t x_q15);

// Returns sqrt of a Q30 value in [0, 2), Q15, within two units.
int32_t coarse_root_q15(uint32_t v_q30);

// Holds 1/v = mantissa·2^-exponent for v > 0, mantissa in [2^14, 2^15]; relative error below 2^-14.
struct CoarseReciprocal {
    int32_t mantissa;
    int exponent;
};
CoarseReciprocal coarse_reciprocal(uint32_t v);

// floor(small·2^15 / large) for small <= large < 2^17: one instruction where the core divides, a table elsewhere.
uint32_t ratio_q15(uint32_t small, uint32_t large);

}  // namespace lumi::detail
