// SPDX-License-Identifier: MIT
// The order of see-through triangles. A number of it is the triangle's, and kInParts where it is not drawn as a whole.
#include "lumi/surface/detail/see_through.h"

#include "surface/begin.h"
#include "surface/lists.h"
#include "surface/seen.h"

namespace lumi::detail
{
namespace
{

constexpr uint32_t kInParts = kLinkMask + 1;

Seen seen(const SurfaceFrame& frame, uint32_t triangle)
{
    const SurfacePatch patch = surface_patch(frame.field, triangle >> 1);
    const SurfaceVertex* const v = frame.memory.vertices;
    const SurfaceVertex *b = v + patch.corner[1], *c = v + patch.corner[2];
    if ((triangle & 1) == 0) return {v + patch.corner[0], b, c};
    return {v + patch.corner[3], c, b};
}

// An entry of the order and where it stands there: by the nearest depth of its triangle, then by that one's number.
// Triangles that reach nearer than the near plane are the last to be drawn.
struct Ranked {
    uint32_t rank;
    uint16_t entry;
};

Ranked ranked(const SurfaceFrame& frame, uint16_t entry)
{
    const uint32_t triangle = entry & kLinkMask;
    const Seen s = seen(frame, triangle);
    const auto depth = [](const SurfaceVertex* v) { return static_cast<int32_t>(depth_of(*v)); };
    const uint32_t nearest =
        s.are_there() ? static_cast<uint32_t>(most_of(depth(s.a), depth(s.b), depth(s.c))) : uint32_t{UINT16_MAX} + 1;
    return {nearest << kLinkBits | triangle, entry};
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

// A heap sort: no memory, and no order of triangles that takes much longer than others.
class FarToNear
{
public:
    FarToNear(const SurfaceFrame& frame, uint16_t* order) : frame_(frame), order_(order) {}

    void sort(uint32_t count)
    {
        for (uint32_t root = count / 2; root-- > 0;) sink(order_[root], root, count);
        for (uint32_t end = count; end > 1;) {
            --end;
            const uint16_t last = order_[end];
            order_[end] = order_[0];
            sink(last, 0, end);
        }
    }

private:
    // Puts an entry into the heap below a free root.
    void sink(uint16_t entry, uint32_t root, uint32_t count)
    {
        const uint32_t rank = ranked(frame_, entry).rank;
        for (uint32_t child = 2 * root + 1; child < count; child = 2 * root + 1) {
            Ranked later = ranked(frame_, order_[child]);
            if (child + 1 < count) {
                const Ranked other = ranked(frame_, order_[child + 1]);
                if (other.rank > later.rank) {
                    later = other;
                    ++child;
                }
            }
            if (later.rank <= rank) break;
            order_[root] = later.entry;
            root = child;
        }
        order_[root] = entry;
    }

    const SurfaceFrame& frame_;
    uint16_t* const order_;
};

// The order's number for a triangle, or nothing where none of it shows: kEmptyBand.
uint32_t entry_of(const SurfaceFrame& frame, uint32_t triangle)
{
    const Seen s = seen(frame, triangle);
    const bool is_there = frame.is_whole || s.are_there();
    if (is_there && (!faces_eye(s) || is_beside(frame, s))) return kEmptyBand;
    light(frame, s.a);
    light(frame, s.b);
    light(frame, s.c);
    return is_there && is_small(frame, s) ? triangle : triangle | kInParts;
}

}  // namespace

void put_see_through(uint32_t patches, uint16_t* order, SeeThroughFrame& frame)
{
    frame.order_count = 0;
    if (frame.columns.begin == frame.columns.end) return;  // nothing shows, and vertices may not be known
    const uint32_t first = frame.field.patch_count;
    for (uint32_t triangle = 2 * first; triangle < 2 * (first + patches); ++triangle) {
        const bool is_lone = surface_patch(frame.field, triangle >> 1).corner[3] == format::kNoVertex;
        const uint32_t entry = is_lone && (triangle & 1) != 0 ? kEmptyBand : entry_of(frame, triangle);
        if (entry != kEmptyBand) order[frame.order_count++] = static_cast<uint16_t>(entry);
    }
    FarToNear(frame, order).sort(frame.order_count);
}

LUMI_HOT bool SeeThroughPieces::next()
{
    while (true) {
        if (parts_.count != 0 && begin_part(piece, frame_, parts_, target_)) return true;
        if (at_ == frame_.order_count) return false;
        const uint32_t entry = frame_.order[at_++];
        if ((entry & kInParts) != 0)
            begin_parts(parts_, frame_, entry & kLinkMask);
        else if (begin_whole(piece, frame_, entry, target_))
            return true;
    }
}

}  // namespace lumi::detail
