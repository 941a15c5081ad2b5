// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/pieces.h"

#include "surface/box.h"
#include "surface/lists.h"
#include "surface/split.h"
#include "surface/textures.h"

namespace lumi::detail
{

TrianglePieces::TrianglePieces(const SurfaceFrame& frame, const Target& target)
    : frame_(frame), target_(target), walk_(walk_of(frame, target)), other_(frame.memory.bands[frame.other_list])
{
    piece.bend = nullptr;
}

LUMI_HOT bool TrianglePieces::next()
{
    if (piece.bend != nullptr) {
        end_triangle(piece, target_);
        return true;
    }
    for (uint32_t triangle = 0; next_listed(walk_, frame_, triangle);)
        if (begin_listed(triangle)) return true;
    return next_part();
}

LUMI_ALWAYS_INLINE bool TrianglePieces::begin_listed(uint32_t triangle)
{
    const SurfacePatch patch = surface_patch(frame_.field, triangle >> 1);
    const SurfaceVertex* const v = frame_.memory.vertices;
    const bool is_first = (triangle & 1) == 0;
    const SurfaceVertex *a = v + patch.corner[0], *b = v + patch.corner[1], *c = v + patch.corner[2];
    if (!is_first) {
        const SurfaceVertex* const first = b;
        a = v + patch.corner[3];
        b = c;
        c = first;
    }
    Box box;
    if (!set_box(box, *a, *b, *c, target_) || is_hidden(*a, *b, *c, box, target_)) return false;
    const Places p = places_of(patch, is_first);
    return begin_triangle(piece, {{a, p.u_q8, p.v_q8}, {b, p.across_q8, p.v_q8}, {c, p.u_q8, p.down_q8}}, box,
                          texture_of(patch, frame_.field), target_);
}

__attribute__((noinline)) bool TrianglePieces::next_part()
{
    while (true) {
        Corner corner[3];
        while (detail::next_part(parts_, frame_, target_, corner)) {
            Box box;
            if (set_box(box, *corner[0].at, *corner[1].at, *corner[2].at, target_) &&
                begin_triangle(piece, corner, box, parts_.texture, target_))
                return true;
        }
        if (other_ == kEmptyBand) return false;
        begin_parts(parts_, frame_, other_);
        other_ = after(other_, frame_.memory.links[other_]);
    }
}

}  // namespace lumi::detail
