// SPDX-License-Identifier: MIT
#include "surface/fill.h"

#include "surface/planes.h"

namespace lumi::detail
{
namespace
{

// At a row from the upper end's first on, which is 0 to 63/64 below it. An edge less than a row high crosses one at
// most.
LUMI_ALWAYS_INLINE EdgeWalk walk_down(const SurfaceVertex& top, const SurfaceVertex& bottom, int32_t row)
{
    const int32_t x = x_q6(top), y = y_q6(top);
    const int32_t first = line_from(y), ahead_q6 = 64 * first + 32 - y;
    const int32_t dx_q6 = x_q6(bottom) - x, dy_q6 = y_q6(bottom) - y;
    const Reciprocal r = reciprocal(static_cast<uint32_t>(dy_q6));
    const int32_t mantissa = static_cast<int32_t>(r.mantissa), shift = 31 - r.leading;
    if (dy_q6 < 64) {
        const int32_t share_q16 = (ahead_q6 * mantissa) >> shift;
        return {x * 1024 + ((dx_q6 * share_q16) >> 6), 0};
    }
    const int32_t step_q16 = (dx_q6 * mantissa) >> shift;
    return {x * 1024 + ((step_q16 * ahead_q6) >> 6) + step_q16 * (row - first), step_q16};
}

// The first sample at a crossing or to its right is the whole part of the crossing plus this.
constexpr int32_t kCentreBias = 0xFFFF - 0x8000;

// A triangle's corners from the upper one on: where the shorter of the edges from there ends, and the longer one.
struct Outline {
    const SurfaceVertex *top, *bend, *bottom;
    uint32_t short_edge;  // 0: left, 1: right
};

// Takes corners that run counter-clockwise on the screen.
LUMI_ALWAYS_INLINE Outline outline_of(const SurfaceVertex* a, const SurfaceVertex* b, const SurfaceVertex* c)
{
    // Packed numbers compare as their upper bits do, and any of two that lie equally high may be the upper one.
    const SurfaceVertex *top = a, *left = b, *right = c;
    if (b->y < a->y || c->y < a->y) {
        const bool b_is_top = b->y < c->y;
        top = b_is_top ? b : c;
        left = b_is_top ? c : a;
        right = b_is_top ? a : b;
    }
    if (left->y < right->y) return {top, left, right, 0};
    return {top, right, left, 1};
}

// From the target's first column on, where it is asked for the first sample at a crossing or to its right.
LUMI_ALWAYS_INLINE EdgeWalk edge_walk(const SurfaceVertex& top, const SurfaceVertex& bottom, int32_t row,
                                      const Target& target)
{
    const EdgeWalk w = walk_down(top, bottom, row);
    return {w.x_q16 + kCentreBias - target.x * 65536, w.step_q16};
}

LUMI_ALWAYS_INLINE void set_edge(Rows& rows, uint32_t edge, const EdgeWalk& w)
{
    rows.edge_q16[edge] = w.x_q16;
    rows.edge_step_q16[edge] = w.step_q16;
}

// Sets the edges of a triangle's rows, of which the first may lie below the bend.
LUMI_ALWAYS_INLINE void set_edges(Rows& rows, const Outline& o, const TriangleSize& size, const Target& target)
{
    const int32_t row = size.first_row, bend = line_from(y_q6(*o.bend));
    set_edge(rows, o.short_edge ^ 1, edge_walk(*o.top, *o.bottom, row, target));
    rows.count = size.end_row - row;
    rows.count_below = 0;
    if (row < bend) {
        end_part();
        set_edge(rows, o.short_edge, edge_walk(*o.top, *o.bend, row, target));
        if (bend >= size.end_row) return;
        rows.count = bend - row;
        rows.count_below = size.end_row - bend;
    }
    end_part();
    const EdgeWalk below = edge_walk(*o.bend, *o.bottom, row < bend ? bend : row, target);
    if (row < bend) {
        rows.bent_edge = o.short_edge;
        rows.below = below;
    } else {
        set_edge(rows, o.short_edge, below);
    }
}

LUMI_ALWAYS_INLINE void set_planes(Rows& rows, const PlaneMaker& maker)
{
    const Plane depth = maker.depth();
    rows.depth = depth.value;
    rows.depth_right = depth.right;
    rows.depth_down = depth.down;
    end_part();
    const Plane place = maker.place();
    rows.place = place.value;
    rows.place_right = place.right;
    rows.place_down = place.down;
    end_part();
    const Plane colour = maker.colour();
    rows.colour = colour.value;
    rows.colour_right = colour.right;
    rows.colour_down = colour.down;
    end_part();
}

// Whether the rounding of a triangle's steps of colour adds up to a few levels from one side to the other.
LUMI_ALWAYS_INLINE bool loses_colour(WideTriangle& wide, const PlaneMaker& maker, const TriangleSize& size)
{
    LUMI_TALLY(Work::wide, 1);
    const PlaneMaker::Lost lost = maker.set_lost(wide);
    wide.is_lost_in_rows = lost.right * size.wide_q6 > kMostLostQ24;
    return wide.is_lost_in_rows || lost.down * size.high_q6 > kMostLostQ24;
}

LUMI_ALWAYS_INLINE void set_memory(Rows& rows, const Texture& texture, const Target& target, int32_t row)
{
    rows.row = target.row(row - target.y);
    rows.texels = texture.texels;
    rows.columns = texture.columns;
    rows.texel_rows = texture.rows;
}

LUMI_ALWAYS_INLINE uint32_t squared(const Length& e)
{
    return static_cast<uint32_t>(e.x_q6 * e.x_q6) + static_cast<uint32_t>(e.y_q6 * e.y_q6);
}

}  // namespace

// Seen along the longest edge, and only along that one, the third corner lies between its ends: no sample gets more or
// less of a quantity than the corners have.
__attribute__((noinline)) Shares shares_of_sliver(Facing& f)
{
    const Length bc = {f.ac.x_q6 - f.ab.x_q6, f.ac.y_q6 - f.ab.y_q6};
    const uint32_t ab2 = squared(f.ab), ac2 = squared(f.ac), bc2 = squared(bc);
    uint32_t length2 = ab2;
    if (bc2 > ab2 && bc2 > ac2) {
        f = {f.b, f.c, f.a, bc, {-f.ab.x_q6, -f.ab.y_q6}};
        length2 = bc2;
    } else if (ac2 > ab2) {
        f = {f.a, f.c, f.b, f.ac, f.ab};
        length2 = ac2;
    }
    if (length2 < 1 << 12) return {0, 0, 0, 0};  // shorter than a sample
    const Reciprocal r = reciprocal(length2);
    return {over_area(f.ab.x_q6, r), over_area(f.ab.y_q6, r), 0, 0};
}

LUMI_HOT bool begin_triangle(TrianglePiece& piece, const Corner (&corner)[3], const TriangleSize& size,
                             const Texture& texture, const Target& target)
{
    const SurfaceVertex &p = *corner[0].at, &q = *corner[1].at, &r = *corner[2].at;
    Facing f = {&corner[0], &corner[1], &corner[2], between(p, q), between(p, r)};
    const int32_t area = doubled_area(f.ab, f.ac);
    if (area >= 0) return false;
    LUMI_TALLY(Work::begun, 1);
    const Outline o = outline_of(f.a->at, f.b->at, f.c->at);
    const Shares shares = shares_of(f, static_cast<uint32_t>(-area), size.longer_q6);
    end_part();
    Rows& rows = piece.rows;
    const PlaneMaker maker(f, shares, target.x, size.first_row);
    set_planes(rows, maker);
    const bool is_wide = may_lose_colour(size.longer_q6, p, q, r) && loses_colour(piece.wide, maker, size);
    end_part();
    set_memory(rows, texture, target, size.first_row);
    piece.is_magnified =
        target.magnified_q10 >= 0 && is_magnified(rows.place_right, rows.place_down, target.magnified_q10);
    if (target.has_two_taps && !piece.is_magnified) rows.place -= kQuarter;
    piece.is_cut = size.is_cut;
    end_part();
    set_edges(rows, o, size, target);
    if (is_wide) begin_wide(piece, rows.edge_step_q16[o.short_edge ^ 1], size.first_row);
    return true;
}

}  // namespace lumi::detail
