// SPDX-License-Identifier: MIT
// Depth over a triangle of the sample grid.
#pragma once

#include "proxy/proxy_fill.h"

namespace lumi::proxy_math
{

// A triangle's corners, the upper one first; `left` ends its left edge from there, or lies on it.
struct Wound {
    SamplePoint top, left, right;
};

// Depth as a function of column and row, modulo 2^32: right wherever the triangle has samples. One anchor for every
// stripe and rectangle, so that each gives the same bits.
struct Ramp {
    enum class Kind : uint8_t {
        none,  // the triangle has no area
        linear,
        exact,  // too steep or too small a triangle for steps: exact_depth
    };

    Kind kind;
    uint32_t right_q14, down_q14;  // a sample
    uint32_t base_q14[2];          // of even and odd rows

    // Column `x` counts from the target's left side, rows from the image's upper one.
    LUMI_ALWAYS_INLINE uint32_t depth_q14(int32_t x, int32_t row) const
    {
        return base_q14[row & 1] + right_q14 * static_cast<uint32_t>(x) + down_q14 * static_cast<uint32_t>(row);
    }
};

// Of a small triangle, and of any.
Ramp small_ramp(const Wound& w, const DepthTarget& target);
Ramp wide_ramp(const Wound& w, const DepthTarget& target);

// The depth at a sample inside: the corners' depths by their shares of the area.
int32_t exact_depth(const Wound& w, int32_t x_q6, int32_t y_q6);

}  // namespace lumi::proxy_math
