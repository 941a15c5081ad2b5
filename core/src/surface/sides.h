// SPDX-License-Identifier: MIT
// The sides of a triangle of a surface field.
#pragma once

#include "lumi/detail/register_hints.h"
#include "surface/bands.h"

namespace lumi::detail
{

// From corner to corner, in the triangle's order.
struct Side {
    uint32_t from, to;
};

// One of a triangle's three: of the first (a, b, c) a-b, c-a, b-c, of the second (d, c, b) d-c, b-d, c-b.
LUMI_ALWAYS_INLINE Side side_of(const SurfacePatch& patch, uint32_t triangle, uint32_t k)
{
    constexpr uint8_t kCorners[2][3][2] = {{{0, 1}, {2, 0}, {1, 2}}, {{3, 2}, {1, 3}, {2, 1}}};
    const uint8_t* ends = kCorners[triangle & 1][k];
    return {patch.corner[ends[0]], patch.corner[ends[1]]};
}

}  // namespace lumi::detail
