// SPDX-License-Identifier: MIT
// The order of see-through triangles, and their pieces.
#include "lumi/surface/detail/see_through.h"

#include "surface/fill.h"
#include "surface/order.h"

namespace lumi::detail
{
namespace
{

bool is_beside(const SurfaceFrame& frame, const Seen& s)
{
    const uint32_t shift = frame.samples_log2 + 14;
    return s.lower() < 0 || s.right() < 0 || s.upper() > frame.height_px << shift || s.left() > frame.width_px << shift;
}

// Puts a number into the heap of `count` whose root is free.
LUMI_ALWAYS_INLINE void sink(uint32_t number, uint32_t* order, uint32_t root, uint32_t count)
{
    for (uint32_t child = 2 * root + 1; child < count; child = 2 * root + 1) {
        if (child + 1 < count && order[child + 1] > order[child]) ++child;
        if (order[child] <= number) break;
        order[root] = order[child];
        root = child;
    }
    order[root] = number;
}

// A heap sort: no memory, and no order of triangles that takes much longer than others.
void sort(uint32_t* order, uint32_t count)
{
    for (uint32_t root = count / 2; root-- > 0;) sink(order[root], order, root, count);
    for (uint32_t end = count; end > 1;) {
        const uint32_t last = order[--end];
        order[end] = order[0];
        sink(last, order, 0, end);
    }
}

// The order's number for a triangle, or kNotSeen where none of it shows.
uint32_t entry_of(const SurfaceFrame& frame, uint32_t triangle)
{
    const Seen s = seen(frame, triangle);
    const bool is_there = frame.is_whole || s.are_there();
    if (is_there && (!faces_eye(s) || is_beside(frame, s))) return kNotSeen;
    light(frame, s.a);
    light(frame, s.b);
    light(frame, s.c);
    const auto depth = [](const SurfaceVertex* v) { return static_cast<int32_t>(depth_of(*v)); };
    const uint32_t nearest =
        is_there ? static_cast<uint32_t>(most_of(depth(s.a), depth(s.b), depth(s.c))) : kNearestOfAll;
    const uint32_t outline = frame.margin != 0 && has_outline(frame, triangle) ? kHasOutline : 0;
    const uint32_t cut = is_there && is_small(frame, s) ? 0 : kIsCut;
    return nearest << kDepthShift | triangle << kTriangleShift | outline | cut;
}

}  // namespace

void put_see_through(SurfaceFrame& frame)
{
    frame.see_through_triangles = 0;
    if (frame.columns.begin == frame.columns.end) return;  // nothing shows, and vertices may not be known
    LUMI_TALLY(Work::see_triangle, 2 * frame.field.see_through_count);
    const uint32_t first = 2 * frame.field.patch_count, end = first + 2 * frame.field.see_through_count;
    uint32_t* const order = frame.memory.features;
    uint32_t count = 0;
    for (uint32_t triangle = first; triangle < end; ++triangle) {
        const bool is_lone = surface_patch(frame.field, triangle >> 1).corner[3] == format::kNoVertex;
        const uint32_t entry = is_lone && (triangle & 1) != 0 ? kNotSeen : entry_of(frame, triangle);
        if (entry != kNotSeen) order[count++] = entry;
    }
    frame.see_through_triangles = static_cast<uint16_t>(count);
    LUMI_TALLY(Work::ordered, count);
    if (count != 0 && !is_in_order(frame.field)) sort(order, count);
}

LUMI_HOT bool SeeThroughPieces::next()
{
    return next_of(
        [&](uint32_t triangle) __attribute__((always_inline)) { begin_cut(cut_, frame_, triangle); });
}

}  // namespace lumi::detail
