// SPDX-License-Identifier: MIT
#include "proxy_fill.h"

#include "lumi/always_inline.h"

namespace lumi::proxy_math
{
namespace
{

// Edges and triangles up to 256 samples wide and high take 32-bit products; others are rare.
constexpr int32_t kSmallQ6 = 1 << 14;

LUMI_ALWAYS_INLINE bool is_small(int32_t difference_q6)
{
    return static_cast<uint32_t>(difference_q6 + kSmallQ6) < 2 * static_cast<uint32_t>(kSmallQ6);
}

// A value along an edge, at the samples' height in each row; both modulo 2^32.
struct Walk {
    int32_t value, step;

    LUMI_ALWAYS_INLINE int32_t after(int32_t rows) const { return wrapped_sum(value, wrapped_product(step, rows)); }
};

// An edge downwards from its upper end.
struct Edge {
    int32_t first_row, end_row;
    int32_t dy_q6, ahead_q6;  // its height; from its upper end to the first row, 0 .. 63
    Reciprocal per_dy;
};

LUMI_ALWAYS_INLINE Edge edge_between(const SamplePoint& top, const SamplePoint& bottom)
{
    const int32_t first = row_from(top.y_q6), dy_q6 = bottom.y_q6 - top.y_q6;
    return {first, row_from(bottom.y_q6), dy_q6, 64 * first + 32 - top.y_q6, reciprocal(static_cast<uint32_t>(dy_q6))};
}

__attribute__((noinline)) Walk wide_walk(const Edge& e, int32_t from, int32_t rise, int fraction_bits)
{
    const int64_t scaled = static_cast<int64_t>(rise) * (int64_t{1} << fraction_bits);
    const int64_t first = static_cast<int64_t>(from) * (int64_t{1} << fraction_bits) + scaled * e.ahead_q6 / e.dy_q6;
    return {static_cast<int32_t>(static_cast<uint32_t>(first)),
            e.dy_q6 < 64 ? 0 : static_cast<int32_t>(static_cast<uint32_t>(64 * scaled / e.dy_q6))};
}

// Where an edge crosses the rows, Q16. One that is less than a row high crosses one at most.
template <bool kSmall>
LUMI_ALWAYS_INLINE Walk x_walk(const Edge& e, int32_t from_q6, int32_t dx_q6)
{
    if (!kSmall && !(e.dy_q6 < kSmallQ6 && is_small(dx_q6))) return wide_walk(e, from_q6, dx_q6, 10);
    const int32_t mantissa = static_cast<int32_t>(e.per_dy.mantissa), shift = 31 - e.per_dy.leading;
    if (e.dy_q6 >= 64) {
        const int32_t step_q16 = (dx_q6 * mantissa) >> shift;
        return {from_q6 * 1024 + ((step_q16 * e.ahead_q6) >> 6), step_q16};
    }
    const int32_t share_q16 = (e.ahead_q6 * mantissa) >> shift;
    return {from_q6 * 1024 + ((dx_q6 * share_q16) >> 6), 0};
}

// Its depth there, Q14.
template <bool kSmall>
LUMI_ALWAYS_INLINE Walk depth_walk(const Edge& e, int32_t from, int32_t rise)
{
    if (!kSmall && e.dy_q6 >= kSmallQ6) return wide_walk(e, from, rise, 14);
    const int32_t mantissa = static_cast<int32_t>(e.per_dy.mantissa);
    if (e.dy_q6 >= 64) {
        const int32_t step_q14 = ((rise >> 1) * mantissa) >> (26 - e.per_dy.leading);
        return {from * 16384 + (step_q14 >> 6) * e.ahead_q6, step_q14};
    }
    const int32_t share_q16 = (e.ahead_q6 * mantissa) >> (31 - e.per_dy.leading);
    return {from * 16384 + (((rise >> 1) * share_q16) >> 1), 0};
}

// How depth grows from sample to sample along a row, Q14. A triangle so thin that depth would grow by more than it has
// in all never holds two samples of a row: there is no step, but a slope from its edge, and its corners' limits.
struct Gradient {
    int32_t step_q14;
    bool thin;
    int32_t slope;  // of a thin one, whole depths a sample
    int32_t least, most;
};

struct Sorted {
    const SamplePoint *top, *middle, *bottom;
};

LUMI_ALWAYS_INLINE Sorted by_height(const SamplePoint& p, const SamplePoint& q, const SamplePoint& r)
{
    Sorted s = {&p, &q, &r};
    const auto order = [](const SamplePoint*& a, const SamplePoint*& b) {
        if (b->y_q6 < a->y_q6) {
            const SamplePoint* t = a;
            a = b;
            b = t;
        }
    };
    order(s.top, s.middle);
    order(s.middle, s.bottom);
    order(s.top, s.middle);
    return s;
}

// Rise of depth from the top to the other corners.
struct Rises {
    int32_t middle, bottom;
};

// A depth a sample of 2^14 wide and 2^16 deep triangles, in whole numbers, fits.
constexpr int32_t kMaxSlope = 1 << 22;

LUMI_ALWAYS_INLINE int32_t limited_slope(int64_t slope)
{
    return static_cast<int32_t>(slope > kMaxSlope ? kMaxSlope : slope < -kMaxSlope ? -kMaxSlope : slope);
}

__attribute__((noinline)) void set_step(Gradient& g, const Sorted& s, const Rises& rise, int64_t area_q12)
{
    const int64_t over_q6 = static_cast<int64_t>(rise.middle) * (s.bottom->y_q6 - s.top->y_q6) -
                            static_cast<int64_t>(rise.bottom) * (s.middle->y_q6 - s.top->y_q6);
    const int64_t step_q14 = over_q6 * (int64_t{1} << 20) / area_q12;
    const int64_t limit_q14 = (g.most - g.least) * int64_t{16384};
    g.thin = step_q14 > limit_q14 || step_q14 < -limit_q14;
    g.step_q14 = g.thin ? 0 : static_cast<int32_t>(step_q14);
    g.slope = limited_slope(step_q14 >> 14);
}

__attribute__((noinline)) void set_thin(Gradient& g, int32_t step, int32_t left)
{
    g.thin = true;
    g.slope = limited_slope(static_cast<int64_t>(step) * (int64_t{1} << left) >> 14);
}

// The same for |area| < 2^31 and heights below 2^14.
LUMI_ALWAYS_INLINE void set_step(Gradient& g, const Sorted& s, const Rises& rise, int32_t area_q12)
{
    const int32_t over_q6 = wrapped_sum(wrapped_product(rise.middle, s.bottom->y_q6 - s.top->y_q6),
                                        wrapped_product(-rise.bottom, s.middle->y_q6 - s.top->y_q6));
    const Reciprocal r = reciprocal(static_cast<uint32_t>(area_q12 < 0 ? -area_q12 : area_q12));
    const int32_t step = times_q16(area_q12 < 0 ? -over_q6 : over_q6, r.mantissa);
    const int32_t left = r.leading - 11;  // at most 20
    if (left <= 0) {
        g.step_q14 = step >> -left;
        return;
    }
    const int32_t most = ((g.most - g.least) * 16384) >> left;
    if (step > most || step < -most) return set_thin(g, step, left);
    g.step_q14 = step * (int32_t{1} << left);
}

// Rows of a triangle between two edges. Samples lie at whole numbers of left and right, which have the rows' phase
// taken off and all but one 2^-16 added: the first sample at or right of an edge is the whole part.
struct Trapezium {
    int32_t left_q16, left_step, right_q16, right_step, depth_q14, depth_step;
    int32_t toggle_q16;  // added to both from the first row to the second, then taken off
    int32_t rows;
};

LUMI_ALWAYS_INLINE void fill_span(uint16_t* at, const uint16_t* end, uint32_t depth_q14, uint32_t step_q14)
{
    do {
        const uint32_t depth = depth_q14 >> 14;
        if (depth > *at) *at = static_cast<uint16_t>(depth);
        depth_q14 += step_q14;
    } while (++at != end);
}

// The depth at the first sample of a thin triangle's row.
int32_t thin_depth_q14(int32_t edge_q14, int32_t ahead_q8, const Gradient& g)
{
    const int32_t depth = (edge_q14 >> 14) + ((g.slope * ahead_q8) >> 8);
    return (depth < g.least ? g.least : depth > g.most ? g.most : depth) * 16384;
}

__attribute__((noinline)) void fill_rows(const Trapezium& all, uint16_t* row, const Gradient& g, int32_t width)
{
    const int32_t step_q14 = g.step_q14;
    Trapezium t = all;
    do {
        int32_t from = t.left_q16 >> 16, to = t.right_q16 >> 16;
        const int32_t ahead_q8 = (~t.left_q16 >> 8) & 0xFF;
        const int32_t edge_q14 = t.depth_q14;
        int32_t depth_q14 = wrapped_sum(edge_q14, (step_q14 >> 8) * ahead_q8);
        t.left_q16 = wrapped_sum(t.left_q16, wrapped_sum(t.left_step, t.toggle_q16));
        t.right_q16 = wrapped_sum(t.right_q16, wrapped_sum(t.right_step, t.toggle_q16));
        t.depth_q14 = wrapped_sum(t.depth_q14, t.depth_step);
        t.toggle_q16 = -t.toggle_q16;
        if (to > width) to = width;
        if (from < to && to > 0) {
            if (g.thin) depth_q14 = thin_depth_q14(edge_q14, ahead_q8, g);
            if (from < 0) {
                depth_q14 = wrapped_sum(depth_q14, wrapped_product(step_q14, -from));
                from = 0;
            }
            fill_span(row + from, row + to, static_cast<uint32_t>(depth_q14), static_cast<uint32_t>(step_q14));
        }
        row += width;
    } while (--t.rows != 0);
}

template <bool kSmall>
class TriangleFiller
{
public:
    LUMI_ALWAYS_INLINE TriangleFiller(const Sorted& s, const Gradient& g, bool middle_is_right,
                                      const DepthTarget& target)
        : s_(s),
          gradient_(g),
          target_(target),
          whole_(edge_between(*s.top, *s.bottom)),
          depth_{0, 0},
          middle_is_right_(middle_is_right)
    {
        x_ = x_walk<kSmall>(whole_, s.top->x_q6, s.bottom->x_q6 - s.top->x_q6);
        if (middle_is_right_) {
            depth_ = depth_walk<kSmall>(whole_, s.top->depth, s.bottom->depth - s.top->depth);
        }
    }

    // The rows of the short edge from `top` to `bottom`.
    __attribute__((noinline)) void fill(const SamplePoint& top, const SamplePoint& bottom) const
    {
        const int32_t first = row_from(top.y_q6), last = row_from(bottom.y_q6);
        const int32_t begin = first > target_.y ? first : target_.y;
        const int32_t end = last < target_.y + target_.height ? last : target_.y + target_.height;
        if (begin >= end) return;
        const Edge e = edge_between(top, bottom);
        const int32_t phase_q16 = target_.phase_q16[begin & 1];
        const int32_t bias_q16 = 0xFFFF - phase_q16;
        // Modulo 2^32: in range again where the row has samples of the target.
        const auto placed = [&](int32_t x_q16) {
            return wrapped_sum(x_q16, wrapped_sum(bias_q16, wrapped_product(target_.x, -65536)));
        };
        const Walk part = x_walk<kSmall>(e, top.x_q6, bottom.x_q6 - top.x_q6);
        const int32_t part_x = placed(part.after(begin - first));
        const int32_t whole_rows = begin - whole_.first_row;
        const int32_t whole_x = placed(x_.after(whole_rows));
        Trapezium t;
        if (middle_is_right_) {
            t = {whole_x, x_.step, part_x, part.step, depth_.after(whole_rows), depth_.step, 0, 0};
        } else {
            const Walk depth = depth_walk<kSmall>(e, top.depth, bottom.depth - top.depth);
            t = {part_x, part.step, whole_x, x_.step, depth.after(begin - first), depth.step, 0, 0};
        }
        t.toggle_q16 = phase_q16 - target_.phase_q16[~begin & 1];
        t.rows = end - begin;
        fill_rows(t, target_.depths + (begin - target_.y) * target_.width, gradient_, target_.width);
    }

private:
    const Sorted& s_;
    const Gradient& gradient_;
    const DepthTarget& target_;
    const Edge whole_;
    Walk x_, depth_;
    const bool middle_is_right_;
};

LUMI_ALWAYS_INLINE Gradient limits(const Sorted& s, const Rises& rise)
{
    const int32_t lower = rise.middle < rise.bottom ? rise.middle : rise.bottom;
    const int32_t upper = rise.middle < rise.bottom ? rise.bottom : rise.middle;
    return {0, false, 0, s.top->depth + (lower < 0 ? lower : 0), s.top->depth + (upper > 0 ? upper : 0)};
}

// Fills a triangle whose doubled area is `area_q12`: 32 bits for a small one, else 64.
template <class Area>
LUMI_ALWAYS_INLINE void fill_sorted(const Sorted& s, Area area_q12, const DepthTarget& target)
{
    if (area_q12 == 0) return;
    const Rises rise = {s.middle->depth - s.top->depth, s.bottom->depth - s.top->depth};
    Gradient g = limits(s, rise);
    set_step(g, s, rise, area_q12);
    const TriangleFiller<sizeof(Area) == sizeof(int32_t)> filler(s, g, area_q12 > 0, target);
    filler.fill(*s.top, *s.middle);
    filler.fill(*s.middle, *s.bottom);
}

__attribute__((noinline)) void fill_wide(const Sorted& s, const DepthTarget& target)
{
    fill_sorted(s, wide_doubled_area(*s.top, *s.middle, *s.bottom), target);
}

}  // namespace

void fill_triangle(const SamplePoint& p, const SamplePoint& q, const SamplePoint& r, const DepthTarget& target)
{
    const Sorted s = by_height(p, q, r);
    const int32_t first = row_from(s.top->y_q6), end = row_from(s.bottom->y_q6);
    if (first >= end || first >= target.y + target.height || end <= target.y) return;
    if (s.bottom->y_q6 - s.top->y_q6 >= kSmallQ6 || !is_small(s.bottom->x_q6 - s.top->x_q6) ||
        !is_small(s.middle->x_q6 - s.top->x_q6) || !is_small(s.bottom->x_q6 - s.middle->x_q6)) {
        return fill_wide(s, target);
    }
    fill_sorted(s, doubled_area(*s.top, *s.middle, *s.bottom), target);
}

}  // namespace lumi::proxy_math
