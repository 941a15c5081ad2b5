// SPDX-License-Identifier: MIT
#include "surface/silhouette.h"

namespace lumi::detail
{
namespace
{

// An edge as lines of samples cross it: scanlines where it is steep, else columns.
struct Crossing {
    int32_t at_q16, step_q16;  // along the line; the first sample's centre is at 0
    int32_t depth_q8, depth_step_q8;
    int32_t first, end;  // lines
};

// The ends by their places along and across the lines; `low` has the lower line.
struct End {
    int32_t line_q6, place_q6, depth;
};

Crossing crossing(const End& low, const End& high, int32_t lines_begin, int32_t lines_end)
{
    const int32_t first = line_from(low.line_q6), last = line_from(high.line_q6);
    Crossing c = {};
    c.first = first > lines_begin ? first : lines_begin;
    c.end = last < lines_end ? last : lines_end;
    if (c.first >= c.end) return c;
    const int32_t begin = line_from(low.line_q6), ahead_q6 = 64 * begin + 32 - low.line_q6, lines = c.first - begin;
    const Reciprocal r = reciprocal(static_cast<uint32_t>(high.line_q6 - low.line_q6));
    // A place changes by at most as much as the line, a depth by less than 2^16.
    c.step_q16 = times_q16((high.place_q6 - low.place_q6) * (1 << (r.leading - 2)), r.mantissa) >> 13;
    c.depth_step_q8 = times_q16((high.depth - low.depth) * (1 << 14), r.mantissa) >> (31 - r.leading);
    const auto placed = [&](int32_t from, int32_t step) {
        return wrapped_sum(from, ((step * ahead_q6) >> 6) + wrapped_product(step, lines));
    };
    c.at_q16 = placed(wrapped_product(low.place_q6, 1024), c.step_q16);
    c.depth_q8 = placed(low.depth * 256, c.depth_step_q8);
    return c;
}

struct Lines {
    int32_t count;          // samples of a line
    int32_t pitch, stride;  // from line to line, from sample to sample
};

// Of several marks of a pixel the largest share stays, so the order of edges does not matter.
LUMI_ALWAYS_INLINE void mark_pixel(uint16_t* depth, uint32_t mark, const Target& target)
{
    constexpr uint32_t kMask = (1u << kMarkBits) - 1;
    PackedColour& colour = target.colours[depth - target.depths];
    const bool is_first = *depth >= kFarDepth && (colour & kMarkedColour) == 0;
    if (!is_first && (*depth & kMask) >= mark) return;
    *depth = static_cast<uint16_t>((*depth & ~kMask) | mark);
    colour |= kMarkedColour;
}

// Marks the outlines where an edge crosses lines between the centres of two samples. The one that the edge cuts shows a
// share of the other. `inward`: +1 where the inside has the larger places.
void mark_crossing(const Crossing& c, int32_t inward, const Lines& lines, const Target& target)
{
    const bool is_scanline = lines.stride == 1;
    const PixelSide to_upper = is_scanline ? PixelSide::right : PixelSide::below;
    const PixelSide to_lower = is_scanline ? PixelSide::left : PixelSide::above;
    const int32_t to_inner = inward > 0 ? lines.stride : 0, to_outer = lines.stride - to_inner;
    const uint32_t pairs = static_cast<uint32_t>(lines.count) - 1;
    int32_t line_at = c.first * lines.pitch, at_q16 = wrapped_sum(c.at_q16, -0x8000), depth_q8 = c.depth_q8;
    for (int32_t left = c.end - c.first; left > 0; --left) {
        const uint32_t lower = static_cast<uint32_t>(at_q16 >> 16), past_q8 = static_cast<uint32_t>(at_q16 >> 8) & 255;
        if (lower < pairs) {
            uint16_t* const depth_at = target.depths + line_at + static_cast<int32_t>(lower) * lines.stride;
            const uint32_t inner = depth_at[to_inner] >> kMarkBits, outer = depth_at[to_outer] >> kMarkBits;
            const uint32_t edge = static_cast<uint32_t>(depth_q8) >> (8 + kMarkBits);
            // A surface in front of the edge hides it, and covers the outer sample too. The inner one may be much
            // nearer than the edge: outlines lie where a surface is steepest.
            if (outer <= edge && outer < inner) {
                const bool cuts_lower = past_q8 < 128;
                const uint32_t share = ((cuts_lower ? 128 - past_q8 : past_q8 - 128) + 4) >> 3;
                if (share != 0) {
                    uint16_t* const cut = depth_at + (cuts_lower ? 0 : lines.stride);
                    mark_pixel(cut, mark_bits(share, cuts_lower ? to_upper : to_lower), target);
                }
            }
        }
        line_at += lines.pitch;
        at_q16 = wrapped_sum(at_q16, c.step_q16);
        depth_q8 = wrapped_sum(depth_q8, c.depth_step_q8);
    }
}

}  // namespace

void mark_edge(const SurfaceVertex& from, const SurfaceVertex& to, const Target& target)
{
    const SamplePoint a = unpacked(from), b = unpacked(to);
    const int32_t left_q6 = target.x * 64, top_q6 = target.y * 64, bottom_q6 = top_q6 + target.height * 64;
    if ((a.y_q6 < top_q6 && b.y_q6 < top_q6) || (a.y_q6 > bottom_q6 && b.y_q6 > bottom_q6)) return;
    const int32_t dx = b.x_q6 - a.x_q6, dy = b.y_q6 - a.y_q6;
    const bool is_steep = magnitude(dy) >= magnitude(dx);
    const auto end = [&](const SamplePoint& p) {
        const int32_t x = p.x_q6 - left_q6, y = p.y_q6 - top_q6, depth = static_cast<int32_t>(p.depth);
        return is_steep ? End{y, x, depth} : End{x, y, depth};
    };
    const bool is_forward = is_steep ? dy > 0 : dx > 0;
    const Lines lines = is_steep ? Lines{target.width, target.width, 1} : Lines{target.height, 1, target.width};
    const Crossing c = is_forward ? crossing(end(a), end(b), 0, is_steep ? target.height : target.width)
                                  : crossing(end(b), end(a), 0, is_steep ? target.height : target.width);
    // Counter-clockwise on the screen, with y down: what goes down has its inside to the right, what goes right above.
    const int32_t inward = is_steep ? (dy > 0 ? 1 : -1) : (dx > 0 ? -1 : 1);
    mark_crossing(c, inward, lines, target);
}

}  // namespace lumi::detail
