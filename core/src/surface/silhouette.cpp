// SPDX-License-Identifier: MIT
#include "surface/silhouette.h"

namespace lumi::surfaces
{
namespace
{

// An edge as lines of samples cross it: rows where it is steep, else columns.
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
    const int32_t first = row_from(low.line_q6), last = row_from(high.line_q6);
    Crossing c = {};
    c.first = first > lines_begin ? first : lines_begin;
    c.end = last < lines_end ? last : lines_end;
    if (c.first >= c.end) return c;
    const int32_t begin = row_from(low.line_q6), ahead_q6 = 64 * begin + 32 - low.line_q6, lines = c.first - begin;
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

// `towards`: from the changed pixel to the one that shows in a part of it.
void mark_pixel(const Target& target, int32_t inner, int32_t outer, bool is_inner_cut, uint32_t share_q8,
                Neighbour towards, uint32_t depth)
{
    const uint32_t d_inner = target.depths[inner] >> kMarkBits, d_outer = target.depths[outer] >> kMarkBits;
    if (d_inner < kFarDepth >> kMarkBits || d_outer >= d_inner) return;
    if (d_inner > depth >> kMarkBits) return;  // another surface in front of the edge
    const uint32_t share = (share_q8 + 4) >> 3;
    if (share == 0) return;
    const int32_t changed = is_inner_cut ? inner : outer;
    const uint32_t mark = static_cast<uint32_t>(towards) << 4 | (share > 15 ? 15 : share);
    target.depths[changed] = static_cast<uint16_t>((is_inner_cut ? d_inner : d_outer) << kMarkBits | mark);
    target.colours[changed] |= kMarkedColour;
}

// `inward`: +1 where the inside has the larger places.
void mark_crossing(const Crossing& c, int32_t inward, const Lines& lines, uint32_t one_surface, const Target& target)
{
    const Neighbour up = lines.stride == 1 ? Neighbour::right : Neighbour::below;
    const Neighbour down = lines.stride == 1 ? Neighbour::left : Neighbour::above;
    int32_t at_q16 = c.at_q16, depth_q8 = c.depth_q8;
    for (int32_t line = c.first; line < c.end; ++line, at_q16 += c.step_q16, depth_q8 += c.depth_step_q8) {
        const int32_t sample = at_q16 >> 16;
        const uint32_t part = (static_cast<uint32_t>(at_q16) >> 8) & 255;  // of the pixel that lies below the edge
        const uint32_t covered = inward > 0 ? 256 - part : part;
        const bool is_inner_cut = covered > 128;
        const int32_t inner = is_inner_cut ? sample : sample + inward, outer = inner - inward;
        if (inner < 0 || outer < 0 || inner >= lines.count || outer >= lines.count) continue;
        mark_pixel(target, line * lines.pitch + inner * lines.stride, line * lines.pitch + outer * lines.stride,
                   is_inner_cut, is_inner_cut ? 256 - covered : covered, (inward > 0) == is_inner_cut ? down : up,
                   static_cast<uint32_t>(depth_q8 >> 8) + one_surface);
    }
}

}  // namespace

void mark_edge(const SurfaceVertex& from, const SurfaceVertex& to, uint32_t one_surface, const Target& target)
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
    mark_crossing(c, inward, lines, one_surface, target);
}

}  // namespace lumi::surfaces
