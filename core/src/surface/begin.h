// SPDX-License-Identifier: MIT
// Begins the pieces of a triangle in a target.
#pragma once

#include "surface/box.h"
#include "surface/split.h"

namespace lumi::detail
{

// Of a triangle that is drawn as a whole; false if none of it shows.
LUMI_ALWAYS_INLINE bool begin_whole(TrianglePiece& piece, const SurfaceFrame& frame, uint32_t triangle,
                                    const Target& target)
{
    const SurfacePatch patch = surface_patch(frame.field, triangle >> 1);
    const SurfaceVertex* const v = frame.memory.vertices;
    const bool is_first = (triangle & 1) == 0;
    const SurfaceVertex *a = v + patch.corner[0], *b = v + patch.corner[1], *c = v + patch.corner[2];
    if (!is_first) {
        const SurfaceVertex* const first = b;
        a = v + patch.corner[3];
        b = c;
        c = first;
    }
    const Seen s = {a, b, c};
    TriangleSize size;
    Extent columns;
    if (!set_size(size, columns, s, target) || is_hidden(s, size, columns, target)) return false;
    const Places p = places_of(patch, is_first);
    return begin_triangle(piece, {{a, p.u_q8, p.v_q8}, {b, p.across_q8, p.v_q8}, {c, p.u_q8, p.down_q8}}, size,
                          texture_of(patch, frame.field), target);
}

// Of the next part of a triangle that begin_parts() began; false after the last.
inline bool begin_part(TrianglePiece& piece, const SurfaceFrame& frame, Parts& parts, const Target& target)
{
    Corner corner[3];
    while (next_part(parts, frame, target, corner)) {
        TriangleSize size;
        Extent columns;
        if (set_size(size, columns, {corner[0].at, corner[1].at, corner[2].at}, target) &&
            begin_triangle(piece, corner, size, parts.texture, target))
            return true;
    }
    return false;
}

}  // namespace lumi::detail
