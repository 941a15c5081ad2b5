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

inline constexpr int32_t kInsetQ8 = 256 >> format::kPatchInsetShift;

LUMI_ALWAYS_INLINE Texture texture_of(const SurfacePatch& patch, const SurfaceField& field)
{
    return {field.texels + patch.texels, patch.columns, patch.rows};
}

// Places in the texture of a patch's first triangle (a, b, c) or second one (d, c, b): from its first corner the one
// goes right and down, the other left and up.
struct Places {
    int32_t u_q8, v_q8, across_q8, down_q8;
};

LUMI_ALWAYS_INLINE Places places_of(const SurfacePatch& patch, bool is_first)
{
    const int32_t right = static_cast<int32_t>(patch.columns << 8) - kInsetQ8;
    const int32_t bottom = static_cast<int32_t>(patch.rows << 8) - kInsetQ8;
    if (is_first) return {kInsetQ8, kInsetQ8, right, bottom};
    return {right, bottom, kInsetQ8, kInsetQ8};
}

struct Box;

// Begins a triangle at most kSmallQ6 wide and high whose corners are there and lie counter-clockwise on the screen;
// false: it lies another way. `box` is the one around it, not empty.
LUMI_HOT bool begin_triangle(TrianglePiece& piece, const Corner (&corner)[3], const Box& box, const Texture& texture,
                             const Target& target);

}  // namespace lumi::detail
