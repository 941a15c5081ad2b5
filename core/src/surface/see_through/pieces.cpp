// SPDX-License-Identifier: MIT
// The order of see-through triangles. A number of it has, from its upper bits down: the nearest depth of the triangle's
// corners, the triangle, and whether it is drawn in parts. So the larger one of two is drawn later.
#include "lumi/surface/detail/see_through.h"

#include "surface/begin.h"
#include "surface/lists.h"
#include "surface/seen.h"

namespace lumi::detail
{
namespace
{

constexpr uint32_t kInParts = 1, kTriangleShift = 1, kDepthShift = kTriangleShift + kLinkBits;
constexpr uint32_t kNotSeen = 0;  // no triangle's number: depths are above 0
// Triangles that reach nearer than the near plane are the last.
constexpr uint32_t kNearestOfAll = UINT16_MAX;
static_assert(kNearestOfAll > kNearDepth && kDepthShift + 16 <= 32, "a number holds all of it");

Seen seen(const SurfaceFrame& frame, uint32_t triangle)
{
    const SurfacePatch patch = surface_patch(frame.field, triangle >> 1);
    const SurfaceVertex* const v = frame.memory.vertices;
    const SurfaceVertex *b = v + patch.corner[1], *c = v + patch.corner[2];
    if ((triangle & 1) == 0) return {v + patch.corner[0], b, c};
    return {v + patch.corner[3], c, b};
}

bool faces_eye(const Seen& s)
{
    const int32_t x = x_q6(*s.a), y = y_q6(*s.a);
    return wide_sign(x_q6(*s.b) - x, y_q6(*s.c) - y, x_q6(*s.c) - x, y_q6(*s.b) - y) < 0;
}

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
    return nearest << kDepthShift | triangle << kTriangleShift | (is_there && is_small(frame, s) ? 0 : kInParts);
}

}  // namespace

void put_see_through(uint32_t patches, uint32_t* order, SeeThroughFrame& frame)
{
    frame.order_count = 0;
    if (frame.columns.begin == frame.columns.end) return;  // nothing shows, and vertices may not be known
    const uint32_t first = frame.field.patch_count;
    for (uint32_t triangle = 2 * first; triangle < 2 * (first + patches); ++triangle) {
        const bool is_lone = surface_patch(frame.field, triangle >> 1).corner[3] == format::kNoVertex;
        const uint32_t entry = is_lone && (triangle & 1) != 0 ? kNotSeen : entry_of(frame, triangle);
        if (entry != kNotSeen) order[frame.order_count++] = entry;
    }
    sort(order, frame.order_count);
}

LUMI_HOT bool SeeThroughPieces::next()
{
    while (true) {
        if (parts_.count != 0 && begin_part(piece, frame_, parts_, target_)) return true;
        if (at_ == frame_.order_count) return false;
        const uint32_t entry = frame_.order[at_++], triangle = entry >> kTriangleShift & kLinkMask;
        if ((entry & kInParts) != 0)
            begin_parts(parts_, frame_, triangle);
        else if (begin_whole(piece, frame_, triangle, target_))
            return true;
    }
}

}  // namespace lumi::detail
