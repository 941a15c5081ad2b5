// SPDX-License-Identifier: MIT
// Fills triangles of the sample grid into a buffer of depths; the nearest stays.
//
// A sample belongs to a triangle if it lies right of the left edge or on it, left of the right edge, and between the
// rows of its ends. Where an edge crosses a row depends on that edge alone, so triangles that share one leave no gap,
// whatever rounding does to it.
#pragma once

#include "proxy_points.h"

namespace lumi::proxy_math
{

// A rectangle of samples in memory.
struct DepthTarget {
    uint16_t* depths;
    int32_t x, y, width, height;  // samples; rows are `width` apart
    int32_t phase_q16[2];         // of the samples in even and odd rows
};

// Fills either side of a triangle.
void fill_triangle(const SamplePoint& p, const SamplePoint& q, const SamplePoint& r, const DepthTarget& target);

}  // namespace lumi::proxy_math
