// SPDX-License-Identifier: MIT
// Numbers of the order of see-through triangles in SurfaceMemory. One has, from its upper bits down: the nearest depth
// of the triangle's corners, the triangle, whether a side of it is an outline that is shown, and whether it is cut into
// pieces. So the larger one of two is drawn later.
#pragma once

#include "lumi/surface/detail/see_through.h"
#include "surface/fill.h"
#include "surface/lists.h"
#include "surface/projection.h"

namespace lumi::detail
{

inline constexpr uint32_t kIsCut = 1, kHasOutline = 2, kTriangleShift = 2, kDepthShift = kTriangleShift + kLinkBits;
inline constexpr uint32_t kNotSeen = 0;  // no triangle's number: depths are above 0
// Triangles that reach nearer than the near plane are the last.
inline constexpr uint32_t kNearestOfAll = UINT16_MAX;
static_assert(kNearestOfAll > kNearDepth && kDepthShift + 16 <= 32, "a number holds all of it");

// Whether see-through triangles are drawn as they stand in the file. Of a field that has some.
inline bool is_in_order(const SurfaceField& field)
{
    return field.see_through[format::see_through::kOrderAt] == static_cast<uint8_t>(format::DrawingOrder::of_the_file);
}

constexpr uint32_t triangle_of(uint32_t number)
{
    return number >> kTriangleShift & kLinkMask;
}

// Returns the corners of a triangle that a patch has.
inline Seen seen(const SurfaceFrame& frame, uint32_t triangle)
{
    const SurfacePatch patch = surface_patch(frame.field, triangle >> 1);
    const SurfaceVertex* const v = frame.memory.vertices;
    const SurfaceVertex *b = v + patch.corner[1], *c = v + patch.corner[2];
    if ((triangle & 1) == 0) return {v + patch.corner[0], b, c};
    return {v + patch.corner[3], c, b};
}

inline bool faces_eye(const Seen& s)
{
    const int32_t x = x_q6(*s.a), y = y_q6(*s.a);
    return wide_sign(x_q6(*s.b) - x, y_q6(*s.c) - y, x_q6(*s.c) - x, y_q6(*s.b) - y) < 0;
}

// Whether nothing that faces the eye lies there, of a neighbour's number.
inline bool is_turned_away(const SurfaceFrame& frame, uint32_t triangle)
{
    if (triangle == format::kNoNeighbour) return true;
    const bool is_second = (triangle & 1) != 0;
    if (is_second && surface_patch(frame.field, triangle >> 1).corner[3] == format::kNoVertex) return true;
    const Seen s = seen(frame, triangle);
    return s.are_there() && !faces_eye(s);
}

// Returns the triangle across a triangle's nth side, numbered as in lists.h.
inline uint32_t across(const SurfaceFrame& frame, const SurfacePatch& patch, uint32_t triangle, uint32_t n)
{
    const uint32_t second = triangle & 1;
    const bool is_lone = patch.corner[3] == format::kNoVertex;
    if (n == 2 && !is_lone) return triangle ^ 1;
    const uint8_t* const at = frame.field.neighbours + (triangle >> 1) * format::kNeighbourBytes + 2 * (2 * second + n);
    return static_cast<uint32_t>(at[0] | at[1] << 8) & format::kNeighbourMask;
}

inline bool is_outline(const SurfaceFrame& frame, const SurfacePatch& patch, uint32_t triangle, uint32_t n)
{
    return is_turned_away(frame, across(frame, patch, triangle, n));
}

inline bool has_outline(const SurfaceFrame& frame, uint32_t triangle)
{
    const SurfacePatch patch = surface_patch(frame.field, triangle >> 1);
    return is_outline(frame, patch, triangle, 0) || is_outline(frame, patch, triangle, 1) ||
           is_outline(frame, patch, triangle, 2);
}

template <class Begin>
LUMI_ALWAYS_INLINE bool SeeThroughPieces::next_of(const Begin& begin)
{
    if (piece.is_wide && next_part_of_wide(piece)) return true;
    while (true) {
        if (cut_.count != 0 && begin_piece(piece, frame_, cut_, target_)) return true;
        if (at_ == frame_.see_through_triangles) return false;
        const uint32_t entry = frame_.memory.features[at_++], triangle = triangle_of(entry);
        if ((entry & kIsCut) != 0)
            begin(triangle);
        else if (begin_whole(piece, frame_, triangle, target_))
            return true;
    }
}

}  // namespace lumi::detail
