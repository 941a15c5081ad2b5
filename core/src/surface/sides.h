// SPDX-License-Identifier: MIT
// The sides of a triangle of a surface field, and which of them are outlines.
#pragma once

#include "surface/bands.h"

namespace lumi::detail
{

// From corner to corner in the triangle's order, and the triangle across.
struct Side {
    uint32_t from, to, neighbour;
};

struct Sides {
    Side side[3];
};

inline Sides sides_of(const SurfaceField& field, const SurfacePatch& patch, uint32_t triangle)
{
    const uint8_t* p = field.neighbours + (triangle >> 1) * format::kNeighbourBytes;
    const auto across = [&](int k) { return static_cast<uint32_t>(p[2 * k] | p[2 * k + 1] << 8); };
    const uint32_t *v = patch.corner, other = triangle ^ 1;
    if ((triangle & 1) != 0) return {{{v[3], v[2], across(2)}, {v[1], v[3], across(3)}, {v[2], v[1], other}}};
    const uint32_t beyond = v[3] == format::kNoVertex ? across(2) : other;
    return {{{v[0], v[1], across(0)}, {v[2], v[0], across(1)}, {v[1], v[2], beyond}}};
}

// Whether nothing that faces the eye lies across. After all triangles are listed.
inline bool is_outline(const SurfaceFrame& frame, const Side& side)
{
    return side.neighbour == format::kNoNeighbour || frame.memory.links[side.neighbour] == kTurnedAway;
}

}  // namespace lumi::detail
