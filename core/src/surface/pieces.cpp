// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/pieces.h"

#include "surface/box.h"
#include "surface/lists.h"
#include "surface/split.h"

namespace lumi::detail
{
namespace
{

constexpr int32_t kInsetQ8 = 256 >> format::kPatchInsetShift;

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

}  // namespace

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
        const SurfacePatch patch = surface_patch(frame_.field, other_ >> 1);
        const bool is_first = (other_ & 1) == 0;
        const Places p = places_of(patch, is_first);
        const uint32_t b = patch.corner[1], c = patch.corner[2];
        parts_.vertex[0] = patch.corner[is_first ? 0 : 3];
        parts_.vertex[1] = is_first ? b : c;
        parts_.vertex[2] = is_first ? c : b;
        parts_.u_q8[0] = parts_.u_q8[2] = p.u_q8;
        parts_.v_q8[0] = parts_.v_q8[1] = p.v_q8;
        parts_.u_q8[1] = p.across_q8;
        parts_.v_q8[2] = p.down_q8;
        parts_.texture = texture_of(patch, frame_.field);
        begin_parts(parts_, frame_);
        other_ = after(other_, frame_.memory.links[other_]);
    }
}

}  // namespace lumi::detail
