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

struct TriangleSize;

// Begins a triangle at most kSmallQ6 wide and high whose corners are there and lie counter-clockwise on the screen;
// false: it lies another way. `size` is its size, and it has rows in the target.
LUMI_HOT bool begin_triangle(TrianglePiece& piece, const Corner (&corner)[3], const TriangleSize& size,
                             const Texture& texture, const Target& target);

// What colour may lose from one side of a triangle to the other, levels: nothing in the middle, and half of it at
// either end. In triangles of less than kWideQ6 samples it never loses more, for blue, which loses most, loses at most
// a quarter level a sample.
inline constexpr int32_t kMostLostQ24 = 6 << 24, kWideQ6 = kMostLostQ24 >> 16;

// Whether rounded steps of colour may lose so much that it takes a look.
LUMI_ALWAYS_INLINE bool may_lose_colour(int32_t longer_q6, const SurfaceVertex& a, const SurfaceVertex& b,
                                        const SurfaceVertex& c)
{
    return longer_q6 >= kWideQ6 && (a.colour | b.colour | c.colour) != 0;
}

// Begins a wide triangle (WideTriangle) with its first part. `wide` holds what is lost; `long_step_q16` is the step of
// the edge from the upper end to the lower one, and `frame_row` that of the piece's first row.
void begin_wide(TrianglePiece& piece, int32_t long_step_q16, int32_t frame_row);

// Makes the piece the next part, after rows have been drawn; false after the last, and then it is not wide any more.
LUMI_HOT bool next_part_of_wide(TrianglePiece& piece);

}  // namespace lumi::detail
