// SPDX-License-Identifier: MIT
// Fills triangles of the sample grid into a buffer of depths; the nearest stays.
//
// A sample belongs to a triangle if it lies right of the left edge or on it, left of the right edge, and between the
// rows of its ends. All of this is decided exactly on the vertices' grid: triangles that share an edge share neither
// a sample nor leave one out, whatever their sizes.
#pragma once

#include "proxy/proxy_points.h"

namespace lumi::proxy_math
{

// A rectangle of samples in memory.
struct DepthTarget {
    uint16_t* depths;
    int32_t x, y, width, height;  // samples; rows are `width` apart
    int32_t phase_q6[2];          // of the samples in even and odd rows
};

// Fills a triangle whose outside is seen and that is small, see proxy_points.h. kShifted: even and odd rows differ in
// phase.
template <bool kShifted>
void fill_small_triangle(const ProxyVertex& p, const ProxyVertex& q, const ProxyVertex& r, const DepthTarget& target);

// Fills either side of a triangle of any size, several times slower.
void fill_triangle(const ProxyVertex& p, const ProxyVertex& q, const ProxyVertex& r, const DepthTarget& target);

}  // namespace lumi::proxy_math
