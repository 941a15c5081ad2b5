// SPDX-License-Identifier: MIT
// Sets up triangles of the grid of samples: depth, texture, colour and edges of their rows.
#pragma once

#include "surface/projection.h"

namespace lumi::detail
{

// A vertex's share of the colour: 3 signed fields of 10 bits, levels times 4.
LUMI_ALWAYS_INLINE int32_t red_q2(uint32_t colour)
{
    return static_cast<int32_t>(colour) >> 22;
}
LUMI_ALWAYS_INLINE int32_t green_q2(uint32_t colour)
{
    return static_cast<int32_t>(colour << 10) >> 22;
}
LUMI_ALWAYS_INLINE int32_t blue_q2(uint32_t colour)
{
    return static_cast<int32_t>(colour << 20) >> 22;
}

struct Box;

// Begins a triangle at most kSmallQ6 wide and high whose corners are there and lie counter-clockwise on the screen;
// false: it lies another way. `box` is the one around it, not empty.
LUMI_HOT bool begin_triangle(TrianglePiece& piece, const Corner (&corner)[3], const Box& box, const Texture& texture,
                             const Target& target);

}  // namespace lumi::detail
