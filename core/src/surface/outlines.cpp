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
    int32_t half_q8;               // half of what the edge moves along a line from one to the next
    uint32_t quarter_by_half_q16;  // 1/(4 half)
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
    // The corner that it cuts off where it is steeper than 1/16 is below 1/128 pixel.
    constexpr int32_t kLeastHalf = 8;
    c.half_q8 = magnitude(c.step_q16) >> 9;
    const Reciprocal h = reciprocal(static_cast<uint32_t>(c.half_q8 > kLeastHalf ? c.half_q8 : kLeastHalf));
    c.quarter_by_half_q16 = h.mantissa >> (33 - h.leading);
}

struct SampleLines {
    int32_t count;          // samples of a line
    int32_t pitch, stride;  // from line to line, from sample to sample, bytes
};

constexpr uint32_t kMarkMask = (1u << kMarkBits) - 1;

LUMI_ALWAYS_INLINE uint16_t& depth_at(uint8_t* p)
{
    return *reinterpret_cast<uint16_t*>(p);
}

uint32_t marks_plane(const Target& target)
{
    return target.marks_words() * static_cast<uint32_t>(target.height);
}

// Whether a marked sample's surface lies in front of that of the other one.
LUMI_ALWAYS_INLINE bool is_in_front(uint8_t* depth, uint32_t mark, int32_t row_bytes)
{
    const int32_t step = (mark & 2) != 0 ? row_bytes : static_cast<int32_t>(sizeof(uint16_t));
    return (depth_at(depth) >> kMarkBits) > (depth_at(depth + ((mark & 1) != 0 ? -step : step)) >> kMarkBits);
}

// Marks a pixel, unless the mark that it has goes before. The depths of samples alone tell which one is in front.
LUMI_ALWAYS_INLINE void mark_pixel(uint8_t* at, uint32_t& bits, uint32_t bit, uint32_t mark, bool is_front,
                                   int32_t row_bytes)
{
    uint16_t& depth = depth_at(at);
    if ((bits & bit) != 0) {
        const uint32_t old = depth & kMarkMask;
        const bool was_front = is_in_front(at, old, row_bytes);
        if (was_front != is_front ? was_front : old >= mark) return;
    }
    bits |= bit;
    depth = static_cast<uint16_t>((depth & ~kMarkMask) | mark);
}

// Marks the outlines where an edge crosses lines between the centres of two samples. Each of the two shows as much of
// the other as lies beyond the edge. Let the edge cross the line at a distance d from the border between the two, and
// move by 2h from one line to the next. The pixel that it crosses loses d, a trapezium. Where h > d the edge crosses
// the border, too, and the triangle there has the area (h - d)²/4h: both pixels lose so much.
// A crease has a surface on both sides, near the edge's own depth.
template <bool kIsSeeThrough>
LUMI_ALWAYS_INLINE void mark_crossing(const Crossing& c, bool inside_is_upper, bool is_crease, const SampleLines& lines,
                                      const Target& target)
{
    const bool is_row = lines.stride == sizeof(uint16_t);
    const PixelSide to_upper = is_row ? PixelSide::right : PixelSide::below;
    const PixelSide to_lower = is_row ? PixelSide::left : PixelSide::above;
    const int32_t to_inner = inside_is_upper ? lines.stride : 0, to_outer = lines.stride - to_inner;
    // A surface at a crease is as near as that to its depth unless it is seen at a grazing angle: 1/32 of the radius.
    constexpr uint32_t kFarLevel = kFarDepth >> kMarkBits, kNear = 16;
    const uint32_t pairs = static_cast<uint32_t>(lines.count) - 1, words = target.marks_words();
    const int32_t row_bytes = static_cast<int32_t>(target.row_bytes);
    uint32_t* const beyond = target.marks + (is_row ? 1 : 2) * marks_plane(target);
    struct MarkPlace {
        uint32_t word, bit;
    };
    const auto place_of = [&](uint32_t x, uint32_t y) { return MarkPlace{y * words + x / 32, 1u << (x & 31)}; };
    LUMI_TALLY(Work::line, c.end - c.first);
    uint8_t* line_at = target.first + c.first * lines.pitch;
    // A sample right at the edge counts as on its upper side, as where triangles are filled.
    int32_t at_q16 = wrapped_sum(c.at_q16, -0x8001), depth_q8 = c.depth_q8;
    for (int32_t line = c.first; line < c.end; ++line) {
        const uint32_t lower = static_cast<uint32_t>(at_q16 >> 16), past_q8 = static_cast<uint32_t>(at_q16 >> 8) & 255;
        if (lower < pairs) {
            uint8_t* const at = line_at + static_cast<int32_t>(lower) * lines.stride;
            const uint32_t inner = depth_at(at + to_inner) >> kMarkBits, outer = depth_at(at + to_outer) >> kMarkBits;
            const uint32_t edge = static_cast<uint32_t>(depth_q8) >> (8 + kMarkBits);
            // A surface in front of the edge hides it, and covers the outer sample too. The inner one may be much
            // nearer than the edge: outlines lie where a surface is steepest. See-through triangles write no depth, so
            // where they alone show, no opaque edge has its inside.
            const auto is_near = [&](uint32_t d) { return d >= kFarLevel && d - edge + kNear <= 2 * kNear; };
            const bool shows = kIsSeeThrough ? outer <= edge && inner <= edge
                               : is_crease   ? is_near(outer) && is_near(inner)
                                             : outer <= edge && outer < inner && inner >= kFarLevel;
            if (shows) {
                const bool cuts_lower = past_q8 < 128;
                const int32_t cut_q8 = static_cast<int32_t>(cuts_lower ? 128 - past_q8 : past_q8 - 128);
                const int32_t left_q8 = c.half_q8 - cut_q8;
                const uint32_t corner_q8 =
                    left_q8 > 0 ? static_cast<uint32_t>(left_q8 * left_q8) * c.quarter_by_half_q16 >> 16 : 0;
                const uint32_t near_q5 = (static_cast<uint32_t>(cut_q8) + corner_q8 + 4) >> 3,
                               far_q5 = (corner_q8 + 4) >> 3;
                const uint32_t across = static_cast<uint32_t>(line);
                const auto place = [&](uint32_t along) {
                    return is_row ? place_of(along, across) : place_of(across, along);
                };
                const auto mark = [&](bool is_upper, uint32_t share) {
                    if (share == 0) return;
                    const bool is_inner = is_upper == inside_is_upper;
                    const bool is_front =
                        kIsSeeThrough || is_crease ? is_inner ? inner > outer : outer > inner : is_inner;
                    const MarkPlace p = place(lower + (is_upper ? 1 : 0));
                    mark_pixel(at + (is_upper ? lines.stride : 0), target.marks[p.word], p.bit,
                               mark_bits(share, is_upper ? to_lower : to_upper), is_front, row_bytes);
                };
                mark(false, cuts_lower ? near_q5 : far_q5);
                mark(true, cuts_lower ? far_q5 : near_q5);
                if (!kIsSeeThrough && !is_crease && near_q5 != 0 && cuts_lower == inside_is_upper) {
                    const MarkPlace p = place(lower);
                    beyond[p.word] |= p.bit;
                }
            }
        }
        line_at += lines.pitch;
        at_q16 = wrapped_sum(at_q16, c.step_q16);
        depth_q8 = wrapped_sum(depth_q8, c.depth_step_q8);
    }
}

template <bool kIsSeeThrough>
LUMI_ALWAYS_INLINE void mark_cut_pixels(const SurfaceVertex& from, const SurfaceVertex& to, bool is_crease,
                                        const Target& target)
{
    LUMI_TALLY(Work::edge, 1);
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
    mark_crossing<kIsSeeThrough>(c, is_forward == is_steep, is_crease, lines, target);
}

bool is_between_lines(const Seen& s)
{
    return line_from_packed(s.upper()) == line_from_packed(s.lower());
}

// Marks the outlines of a triangle that lies between scanlines, and of those behind it that do: they are in no list.
// All of them lie between the same two, so whatever has samples there reaches them in every stripe that shows them.
__attribute__((noinline)) void mark_thin(const SurfaceFrame& frame, uint32_t from, uint32_t triangle,
                                         const Target& target)
{
    constexpr int kMost = 8;  // triangles; a chain of them may be a ring
    const SurfaceVertex* const v = frame.memory.vertices;
    for (int count = 0; count < kMost && is_between_lines(seen(frame, triangle)); ++count) {
        const SurfacePatch patch = surface_patch(frame.field, triangle >> 1);
        uint32_t next = format::kNoNeighbour;
        for (uint32_t n = 0; n < 3; ++n) {
            const uint32_t beyond = across(frame, patch, triangle, n);
            const uint16_t link = beyond == format::kNoNeighbour ? kTurnedAway : frame.memory.links[beyond];
            const Side side = side_of(patch, triangle, n);
            if (link == kTurnedAway)
                mark_edge(v[side.from], v[side.to], false, target);
            else if (link == kWithoutSamples && beyond != from)
                next = beyond;
        }
        if (next == format::kNoNeighbour) return;
        from = triangle;
        triangle = next;
    }
}

// Drops those in the pairs of rows, or of columns.
__attribute__((noinline)) void drop_inner_of(const Target& target, bool is_row)
{
    // A smaller share may be the corner that an edge on the other side cuts off: that is at most 1/8, at 45 degrees.
    constexpr uint32_t kLeastInner = 5;
    const int32_t stride = is_row ? static_cast<int32_t>(sizeof(uint16_t)) : static_cast<int32_t>(target.row_bytes);
    const uint32_t words = target.marks_words(), height = static_cast<uint32_t>(target.height);
    const uint32_t* beyond = target.marks + (is_row ? 1 : 2) * marks_plane(target);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t first = 0; first < 32 * words; first += 32)
            for (uint32_t bits = *beyond++; bits != 0; bits &= bits - 1) {
                const uint32_t x = first + static_cast<uint32_t>(__builtin_ctz(bits));
                uint8_t* const lower = target.row(static_cast<int32_t>(y)) + x * sizeof(uint16_t);
                const uint32_t upper_depth = depth_at(lower + stride), lower_depth = depth_at(lower);
                const uint32_t is_upper = upper_depth > lower_depth ? 1 : 0;
                const uint32_t mark = is_upper != 0 ? upper_depth : lower_depth;
                if ((mark & 3) != ((is_row ? 0 : 2) | is_upper) || (mark & kMarkMask) >> 2 < kLeastInner) continue;
                const uint32_t column = x + (is_row ? is_upper : 0), row = y + (is_row ? 0 : is_upper);
                target.marks[row * words + column / 32] &= ~(1u << (column & 31));
            }
}

void mark_sides(const SurfaceFrame& frame, uint32_t k, uint32_t sides, const Target& target)
{
    LUMI_TALLY(Work::outline, 1);
    const SurfacePatch patch = surface_patch(frame.field, k >> 1);
    const SurfaceVertex* v = frame.memory.vertices;
    const uint32_t odd = k & 1;
    if (!reaches({&v[patch.corner[3 * odd]], &v[patch.corner[1]], &v[patch.corner[2]]}, target)) return;
    for (uint32_t m = 0; sides != 0; ++m, sides >>= 1) {
        if ((sides & 1) == 0) continue;
        const uint32_t beyond = across(frame, patch, k, m);
        const uint16_t link = beyond == format::kNoNeighbour ? kTurnedAway : frame.memory.links[beyond];
        if (link == kWithoutSamples) {
            mark_thin(frame, k, beyond, target);
            continue;
        }
        const Side side = side_of(patch, k, m);
        if (is_there(v[side.from]) && is_there(v[side.to]))
            mark_edge(v[side.from], v[side.to], link != kTurnedAway, target);
    }
}

void mark_see_through_sides(const SurfaceFrame& frame, uint32_t triangle, const Target& target)
{
    LUMI_TALLY(Work::outline, 1);
    const Seen s = seen(frame, triangle);
    if (!reaches(s, target)) return;
    const SurfacePatch patch = surface_patch(frame.field, triangle >> 1);
    const SurfaceVertex* const v = frame.memory.vertices;
    for (uint32_t n = 0; n < 3; ++n) {
        const Side side = side_of(patch, triangle, n);
        if (is_there(v[side.from]) && is_there(v[side.to]) && is_outline(frame, patch, triangle, n))
            mark_cut_pixels<true>(v[side.from], v[side.to], false, target);
    }
}

}  // namespace

LUMI_HOT __attribute__((noinline)) void mark_edge(const SurfaceVertex& from, const SurfaceVertex& to, bool is_crease,
                                                  const Target& target)
{
    mark_cut_pixels<false>(from, to, is_crease, target);
}

LUMI_HOT void drop_inner_edges(const Target& target)
{
    drop_inner_of(target, true);
    drop_inner_of(target, false);
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
    drop_inner_edges(target);
}

void mark_see_through_outlines(const SurfaceFrame& frame, const Target& target)
{
    const uint32_t* const order = frame.memory.features;
    for (uint32_t k = 0; k < frame.see_through_triangles; ++k)
        if ((order[k] & kHasOutline) != 0) mark_see_through_sides(frame, triangle_of(order[k]), target);
}

}  // namespace lumi::detail
