// SPDX-License-Identifier: MIT
// How depth, texture coordinates and colour change over a triangle of the grid of samples.
#pragma once

#include "surface/fill.h"

namespace lumi::surfaces
{

// Twice the area, Q12; negative where the corners run counter-clockwise on the screen. Of small triangles.
LUMI_ALWAYS_INLINE int32_t doubled_area(const SamplePoint& a, const SamplePoint& b, const SamplePoint& c)
{
    return (b.x_q6 - a.x_q6) * (c.y_q6 - a.y_q6) - (c.x_q6 - a.x_q6) * (b.y_q6 - a.y_q6);
}

// A triangle's corners, the upper one first; `left` ends its left edge from there, or lies on it.
struct Wound {
    const Corner *top, *left, *right;
};

// Per sample to the right and per sample down.
struct Slope {
    int32_t right, down;
};

// From a corner to a sample.
struct Offset {
    int32_t x_q6, y_q6;
};

// A slope's rise over an offset, modulo 2^32.
LUMI_ALWAYS_INLINE uint32_t along(const Slope& s, const Offset& to)
{
    const uint32_t right = static_cast<uint32_t>(s.right), down = static_cast<uint32_t>(s.down);
    const auto part = [](int32_t slope, int32_t q6) { return static_cast<uint32_t>((slope >> 6) * (q6 & 63)); };
    return right * static_cast<uint32_t>(to.x_q6 >> 6) + down * static_cast<uint32_t>(to.y_q6 >> 6) +
           part(s.right, to.x_q6) + part(s.down, to.y_q6);
}

struct Slopes {
    Slope depth;      // Q14
    Slope u, v;       // Q10 texels
    Slope colour[3];  // levels, Q16

    // Of a triangle with an area, at most kSmallQ6 wide and high.
    void set(const Wound& w);
};

}  // namespace lumi::surfaces
