// SPDX-License-Identifier: MIT
// The sides of a triangle of a surface field, and which of them are outlines.
#pragma once

#include "lumi/detail/register_hints.h"
#include "surface/bands.h"

namespace lumi::detail
{

// From corner to corner in the triangle's order, and the triangle across.
struct Side {
    uint32_t from, to, neighbour;
};

// One of a triangle's three.
LUMI_ALWAYS_INLINE Side side_of(const SurfaceField& field, const SurfacePatch& patch, uint32_t triangle, uint32_t k)
{
    constexpr uint8_t kCorners[2][3][2] = {{{0, 1}, {2, 0}, {1, 2}}, {{3, 2}, {1, 3}, {2, 1}}};
    const uint8_t* p = field.neighbours + (triangle >> 1) * format::kNeighbourBytes;
    const auto across = [&](uint32_t n) { return static_cast<uint32_t>(p[2 * n] | p[2 * n + 1] << 8); };
    const uint32_t odd = triangle & 1;
    const uint8_t* ends = kCorners[odd][k];
    const bool is_alone = patch.corner[3] == format::kNoVertex;
    return {patch.corner[ends[0]], patch.corner[ends[1]],
            k < 2      ? across(2 * odd + k)
            : is_alone ? across(2)
                       : triangle ^ 1};
}

// Whether nothing that faces the eye lies across. After all triangles are listed.
inline bool is_outline(const SurfaceFrame& frame, const Side& side)
{
    return side.neighbour == format::kNoNeighbour || frame.memory.links[side.neighbour] == kTurnedAway;
}

}  // namespace lumi::detail
