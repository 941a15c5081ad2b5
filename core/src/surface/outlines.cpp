// SPDX-License-Identifier: MIT
// Marks the pixels that edges of outlines cut, opaque edges and those of see-through triangles.
#include "lumi/surface/detail/see_through.h"
#include "surface/fill.h"
#include "surface/lists.h"
#include "surface/order.h"

namespace lumi::detail
{
namespace
{

// An edge as lines of samples cross it: scanlines where it is steep, else columns.
struct Crossing {
    int32_t first, end;        // lines
    int32_t at_q16, step_q16;  // along the line; the first sample's centre is at 0
    int32_t depth_q8, depth_step_q8;
};

// An edge's ends by their places along and across the lines; `low` has the lower line.
struct Ends {
    int32_t low_line_q6, high_line_q6, low_place_q6, high_place_q6;
    int32_t low_depth, high_depth;
};

LUMI_ALWAYS_INLINE void set_steps(Crossing& c, const Ends& e)
{
    const int32_t begin = line_from(e.low_line_q6), ahead_q6 = 64 * begin + 32 - e.low_line_q6;
    const Reciprocal r = reciprocal(static_cast<uint32_t>(e.high_line_q6 - e.low_line_q6));
    // A place changes by at most as much as the line, a depth by less than 2^16.
    c.step_q16 = times_q16((e.high_place_q6 - e.low_place_q6) * (1 << (r.leading - 2)), r.mantissa) >> 13;
    c.depth_step_q8 = ((e.high_depth - e.low_depth) / 2 * static_cast<int32_t>(r.mantissa)) >> (32 - r.leading);
    const auto placed = [&](int32_t from, int32_t step) {
        return wrapped_sum(from, ((step * ahead_q6) >> 6) + wrapped_product(step, c.first - begin));
    };
    c.at_q16 = placed(wrapped_product(e.low_place_q6, 1024), c.step_q16);
    c.depth_q8 = placed(e.low_depth * 256, c.depth_step_q8);
}

struct SampleLines {
    int32_t count;          // samples of a line
    int32_t pitch, stride;  // from line to line, from sample to sample, bytes
};

// Marks a pixel. The largest share of several marks stays, so the order of edges does not matter.
LUMI_ALWAYS_INLINE void mark_pixel(uint16_t& depth, uint32_t& bits, uint32_t bit, uint32_t mark)
{
    constexpr uint32_t kMask = (1u << kMarkBits) - 1;
    if ((bits & bit) != 0 && (depth & kMask) >= mark) return;
    bits |= bit;
    depth = static_cast<uint16_t>((depth & ~kMask) | mark);
}

// Marks the outlines where an edge crosses lines between the centres of two samples. The one that the edge cuts shows a
// share of the other.
template <bool kIsSeeThrough>
LUMI_ALWAYS_INLINE void mark_crossing(const Crossing& c, bool inside_is_upper, const SampleLines& lines,
                                      const Target& target)
{
    const bool is_row = lines.stride == sizeof(uint16_t);
    const PixelSide to_upper = is_row ? PixelSide::right : PixelSide::below;
    const PixelSide to_lower = is_row ? PixelSide::left : PixelSide::above;
    const int32_t to_inner = inside_is_upper ? lines.stride : 0, to_outer = lines.stride - to_inner;
    constexpr uint32_t kFarLevel = kFarDepth >> kMarkBits;
    const uint32_t pairs = static_cast<uint32_t>(lines.count) - 1, words = target.marks_words();
    uint8_t* line_at = target.first + c.first * lines.pitch;
    int32_t at_q16 = wrapped_sum(c.at_q16, -0x8000), depth_q8 = c.depth_q8;
    const auto depth_at = [](uint8_t* p) -> uint16_t& { return *reinterpret_cast<uint16_t*>(p); };
    for (int32_t line = c.first; line < c.end; ++line) {
        const uint32_t lower = static_cast<uint32_t>(at_q16 >> 16), past_q8 = static_cast<uint32_t>(at_q16 >> 8) & 255;
        if (lower < pairs) {
            uint8_t* const at = line_at + static_cast<int32_t>(lower) * lines.stride;
            const uint32_t inner = depth_at(at + to_inner) >> kMarkBits, outer = depth_at(at + to_outer) >> kMarkBits;
            const uint32_t edge = static_cast<uint32_t>(depth_q8) >> (8 + kMarkBits);
            // A surface in front of the edge hides it, and covers the outer sample too. The inner one may be much
            // nearer than the edge: outlines lie where a surface is steepest. See-through triangles write no depth, so
            // where they alone show, no opaque edge has its inside.
            if (outer <= edge && (kIsSeeThrough ? inner <= edge : outer < inner && inner >= kFarLevel)) {
                const bool cuts_lower = past_q8 < 128;
                const uint32_t share = ((cuts_lower ? 128 - past_q8 : past_q8 - 128) + 4) >> 3;
                if (share != 0) {
                    const uint32_t cut = lower + (cuts_lower ? 0 : 1), other = static_cast<uint32_t>(line);
                    const uint32_t x = is_row ? cut : other, y = is_row ? other : cut;
                    mark_pixel(depth_at(at + (cuts_lower ? 0 : lines.stride)), target.marks[y * words + x / 32],
                               1u << (x & 31), mark_bits(share, cuts_lower ? to_upper : to_lower));
                }
            }
        }
        line_at += lines.pitch;
        at_q16 = wrapped_sum(at_q16, c.step_q16);
        depth_q8 = wrapped_sum(depth_q8, c.depth_step_q8);
    }
}

template <bool kIsSeeThrough>
LUMI_ALWAYS_INLINE void mark_cut_pixels(const SurfaceVertex& from, const SurfaceVertex& to, const Target& target)
{
    constexpr int32_t kBetween = sizeof(uint16_t);
    const int32_t left_q6 = target.x * 64, top_q6 = target.y * 64, row_bytes = static_cast<int32_t>(target.row_bytes);
    const int32_t dx = x_q6(to) - x_q6(from), dy = y_q6(to) - y_q6(from);
    const bool is_steep = magnitude(dy) >= magnitude(dx), is_forward = is_steep ? dy > 0 : dx > 0;
    const SurfaceVertex &low = is_forward ? from : to, &high = is_forward ? to : from;
    Ends e = {x_q6(low) - left_q6, x_q6(high) - left_q6, y_q6(low) - top_q6, y_q6(high) - top_q6, 0, 0};
    SampleLines lines = {target.height, kBetween, row_bytes};
    int32_t count = target.width;
    if (is_steep) {
        e = {e.low_place_q6, e.high_place_q6, e.low_line_q6, e.high_line_q6, 0, 0};
        lines = {target.width, row_bytes, kBetween};
        count = target.height;
    }
    Crossing c;
    const int32_t begin = line_from(e.low_line_q6), end = line_from(e.high_line_q6), across_q6 = 64 * lines.count;
    c.first = begin > 0 ? begin : 0;
    c.end = end < count ? end : count;
    const bool is_beside =
        (e.low_place_q6 < 0 && e.high_place_q6 < 0) || (e.low_place_q6 > across_q6 && e.high_place_q6 > across_q6);
    if (c.first >= c.end || is_beside) return;
    e.low_depth = static_cast<int32_t>(depth_of(low));
    e.high_depth = static_cast<int32_t>(depth_of(high));
    set_steps(c, e);
    // Counter-clockwise on the screen, with y down: what goes down has its inside to the right, what goes right above.
    mark_crossing<kIsSeeThrough>(c, is_forward == is_steep, lines, target);
}

void mark_sides(const SurfaceFrame& frame, uint32_t k, uint32_t sides, const Target& target)
{
    const SurfacePatch patch = surface_patch(frame.field, k >> 1);
    const SurfaceVertex* v = frame.memory.vertices;
    const uint32_t odd = k & 1;
    if (!reaches({&v[patch.corner[3 * odd]], &v[patch.corner[1]], &v[patch.corner[2]]}, target)) return;
    for (uint32_t m = 0; sides != 0; ++m, sides >>= 1) {
        if ((sides & 1) == 0) continue;
        const Side side = side_of(patch, k, m);
        if (is_there(v[side.from]) && is_there(v[side.to])) mark_edge(v[side.from], v[side.to], target);
    }
}

void mark_see_through_sides(const SurfaceFrame& frame, uint32_t triangle, const Target& target)
{
    const Seen s = seen(frame, triangle);
    if (!reaches(s, target)) return;
    const SurfacePatch patch = surface_patch(frame.field, triangle >> 1);
    const SurfaceVertex* const v = frame.memory.vertices;
    for (uint32_t n = 0; n < 3; ++n) {
        const Side side = side_of(patch, triangle, n);
        if (is_there(v[side.from]) && is_there(v[side.to]) && is_outline(frame, patch, triangle, n))
            mark_cut_pixels<true>(v[side.from], v[side.to], target);
    }
}

}  // namespace

LUMI_HOT __attribute__((noinline)) void mark_edge(const SurfaceVertex& from, const SurfaceVertex& to,
                                                  const Target& target)
{
    mark_cut_pixels<false>(from, to, target);
}

LUMI_HOT void mark_outlines(const SurfaceFrame& frame, const Target& target)
{
    const auto mark = [&](uint32_t triangle) {
        if (const uint32_t sides = outline_sides_of(frame, triangle); sides != 0)
            mark_sides(frame, triangle, sides, target);
    };
    ListWalk walk = walk_of(frame, target);
    for (uint32_t triangle = 0; next_listed(walk, frame, triangle);) mark(triangle);
    for (uint32_t other = frame.memory.bands[frame.other_list]; other != kEmptyBand;) {
        mark(other);
        other = after(other, frame.memory.links[other]);
    }
}

LUMI_HOT void mark_see_through_outlines(const SurfaceFrame& frame, const Target& target)
{
    const uint32_t* const order = frame.memory.see_through;
    for (uint32_t k = 0; k < frame.see_through_triangles; ++k)
        if ((order[k] & kHasOutline) != 0) mark_see_through_sides(frame, triangle_of(order[k]), target);
}

}  // namespace lumi::detail
