// SPDX-License-Identifier: MIT
#include "proxy/proxy_fill.h"

#include "lumi/detail/register_hints.h"
#include "lumi/render.h"
#include "proxy/proxy_ramp.h"

namespace lumi::proxy_math
{
namespace
{

// Where an edge crosses the rows, Q16 samples, modulo 2^32.
struct Walk {
    int32_t x_q16, step_q16;
};

LUMI_ALWAYS_INLINE bool is_small(int32_t difference_q6)
{
    return static_cast<uint32_t>(difference_q6 + kSmallQ6) < 2 * static_cast<uint32_t>(kSmallQ6);
}

__attribute__((noinline)) Walk wide_walk(int32_t x_q6, int32_t dx_q6, int32_t dy_q6, int32_t ahead_q6)
{
    const int64_t dx_q16 = static_cast<int64_t>(dx_q6) * 1024;
    const int64_t first_q16 = static_cast<int64_t>(x_q6) * 1024 + dx_q16 * ahead_q6 / dy_q6;
    return {static_cast<int32_t>(static_cast<uint32_t>(first_q16)),
            dy_q6 < 64 ? 0 : static_cast<int32_t>(static_cast<uint32_t>(64 * dx_q16 / dy_q6))};
}

// From the first row at or below the upper end on; that row is `ahead`, 0 to 63/64, below it. An edge that is less than
// a row high crosses one at most.
LUMI_ALWAYS_INLINE Walk small_walk(int32_t x_q6, int32_t dx_q6, int32_t dy_q6, int32_t ahead_q6)
{
    const Reciprocal r = reciprocal(static_cast<uint32_t>(dy_q6));
    const int32_t mantissa = static_cast<int32_t>(r.mantissa), shift = 31 - r.leading;
    if (dy_q6 >= 64) {
        const int32_t step_q16 = (dx_q6 * mantissa) >> shift;
        return {x_q6 * 1024 + ((step_q16 * ahead_q6) >> 6), step_q16};
    }
    const int32_t share_q16 = (ahead_q6 * mantissa) >> shift;
    return {x_q6 * 1024 + ((dx_q6 * share_q16) >> 6), 0};
}

// The crossing with a row at or below the upper end, and from there on. The same bits for both triangles of an edge.
template <bool kSmall>
LUMI_ALWAYS_INLINE Walk walk_from(const SamplePoint& top, const SamplePoint& bottom, int32_t row)
{
    const int32_t first = row_from(top.y_q6), ahead_q6 = 64 * first + 32 - top.y_q6;
    const int32_t dx_q6 = bottom.x_q6 - top.x_q6, dy_q6 = bottom.y_q6 - top.y_q6;
    const Walk w = kSmall || (dy_q6 < kSmallQ6 && is_small(dx_q6)) ? small_walk(top.x_q6, dx_q6, dy_q6, ahead_q6)
                                                                   : wide_walk(top.x_q6, dx_q6, dy_q6, ahead_q6);
    return {wrapped_sum(w.x_q16, wrapped_product(w.step_q16, row - first)), w.step_q16};
}

// What makes a crossing's whole part the first sample at it or to its right.
LUMI_ALWAYS_INLINE int32_t bias_q16(const DepthTarget& target, int32_t row)
{
    return 0xFFFF - 1024 * target.phase_q6[row & 1];
}

LUMI_ALWAYS_INLINE void fill_span(uint16_t* at, const uint16_t* end, uint32_t depth_q14, uint32_t step_q14)
{
    do {
        const uint32_t depth = depth_q14 >> 14;
        if (depth > *at) *at = static_cast<uint16_t>(depth);
        depth_q14 += step_q14;
    } while (++at != end);
}

// Image rows [begin, end) of a triangle within the target, and the row where its short edges meet.
struct Rows {
    int32_t begin, bend, end;

    LUMI_ALWAYS_INLINE Rows(const Wound& w, const DepthTarget& target)
    {
        const bool left_is_short = w.left.y_q6 < w.right.y_q6;
        const int32_t first = row_from(w.top.y_q6), below = target.y + target.height;
        const int32_t last = row_from(left_is_short ? w.right.y_q6 : w.left.y_q6);
        begin = first > target.y ? first : target.y;
        bend = row_from(left_is_short ? w.left.y_q6 : w.right.y_q6);
        end = last < below ? last : below;
    }
};

// Turns a triangle's corners until the upper one is first. Depth's bits below y's decide between corners of the same
// height, which may come in any order.
LUMI_ALWAYS_INLINE Wound from_top(const ProxyVertex* a, const ProxyVertex* b, const ProxyVertex* c)
{
    if (b->y < a->y && b->y <= c->y) return {unpacked(*b), unpacked(*c), unpacked(*a)};
    if (c->y < a->y) return {unpacked(*c), unpacked(*a), unpacked(*b)};
    return {unpacked(*a), unpacked(*b), unpacked(*c)};
}

// A triangle's edges, from the row where it begins or its short edges meet; x_q16 from `place_q16` on.
template <bool kSmall>
LUMI_ALWAYS_INLINE void set_edges(const Wound& w, bool is_first, bool is_lower, int32_t row, int32_t place_q16,
                                  Walk& left, Walk& right)
{
    const auto placed = [&](const SamplePoint& top, const SamplePoint& bottom) {
        const Walk walk = walk_from<kSmall>(top, bottom, row);
        return Walk{wrapped_sum(walk.x_q16, place_q16), walk.step_q16};
    };
    const bool left_is_short = w.left.y_q6 < w.right.y_q6;
    if (is_lower && left_is_short) {
        left = placed(w.left, w.right);
    } else if (is_first) {
        left = placed(w.top, w.left);
    }
    if (is_lower && !left_is_short) {
        right = placed(w.right, w.left);
    } else if (is_first) {
        right = placed(w.top, w.right);
    }
}

// A small triangle on its way down the target, without clipping or exact depths.
template <bool kShifted>
class Descent
{
public:
    LUMI_ALWAYS_INLINE Descent(const Ramp& ramp, int32_t y, const DepthTarget& target)
        : y_(y),
          row_(target.depths + (y - target.y) * target.width),
          width_(target.width),
          depth_q14_(ramp.depth_q14(0, y)),
          right_q14_(ramp.right_q14),
          down_q14_(ramp.down_q14),
          place_q16_(bias_q16(target, y) - 65536 * target.x)
    {
        if (!kShifted) return;
        shift_q16_ = bias_q16(target, ~y) - bias_q16(target, y);
        shift_q14_ = ramp.base_q14[~y & 1] - ramp.base_q14[y & 1];
    }

    LUMI_ALWAYS_INLINE void fill(const Wound& w, const Rows& rows)
    {
        set_edges<true>(w, true, y_ >= rows.bend, y_, place_q16_, left_, right_);
        if (y_ < rows.bend && rows.bend < rows.end) {
            fill_until(rows.bend);
            set_edges<true>(w, false, true, y_, place_q16_, left_, right_);
        }
        fill_until(rows.end);
    }

private:
    LUMI_ALWAYS_INLINE void fill_until(int32_t end)
    {
        do {
            const bool shifted = kShifted && is_shifted_;
            fill_row((left_.x_q16 + (shifted ? shift_q16_ : 0)) >> 16,
                     (right_.x_q16 + (shifted ? shift_q16_ : 0)) >> 16, shifted ? depth_q14_ + shift_q14_ : depth_q14_);
            left_.x_q16 += left_.step_q16;
            right_.x_q16 += right_.step_q16;
            row_ += width_;
            depth_q14_ += down_q14_;
            is_shifted_ = !is_shifted_;
        } while (++y_ != end);
    }

    LUMI_ALWAYS_INLINE void fill_row(int32_t from, int32_t to, uint32_t depth_q14)
    {
        if (from < 0) from = 0;
        if (to > width_) to = width_;
        if (from >= to) return;
        fill_span(row_ + from, row_ + to, depth_q14 + right_q14_ * static_cast<uint32_t>(from), right_q14_);
    }

    int32_t y_;
    uint16_t* row_;
    const int32_t width_;
    uint32_t depth_q14_;
    const uint32_t right_q14_, down_q14_;
    const int32_t place_q16_;
    Walk left_{0, 0}, right_{0, 0};
    // Of the second row, the fourth and so on.
    int32_t shift_q16_ = 0;
    uint32_t shift_q14_ = 0;
    bool is_shifted_ = false;
};

// Columns [from, to) of a row of the target.
__attribute__((noinline)) void fill_exactly(const Wound& w, const DepthTarget& target, int32_t row, RowSpan columns)
{
    uint16_t* const at = target.depths + (row - target.y) * target.width;
    for (int32_t x = columns.begin; x < columns.end; ++x) {
        const int32_t depth = exact_depth(w, 64 * (x + target.x) + target.phase_q6[row & 1], 64 * row + 32);
        if (depth > at[x]) at[x] = static_cast<uint16_t>(depth);
    }
}

// The first sample at a crossing or to its right, within the target.
int32_t column_of(const Walk& walk, int32_t row, const DepthTarget& target)
{
    const int32_t x = (wrapped_sum(walk.x_q16, bias_q16(target, row)) >> 16) - target.x;
    return x < 0 ? 0 : x > target.width ? target.width : x;
}

void fill_columns(const Wound& w, const Ramp& ramp, int32_t y, const RowSpan& columns, const DepthTarget& target)
{
    if (columns.begin >= columns.end) return;
    if (ramp.kind == Ramp::Kind::exact) return fill_exactly(w, target, y, columns);
    uint16_t* const row = target.depths + (y - target.y) * target.width;
    fill_span(row + columns.begin, row + columns.end, ramp.depth_q14(columns.begin, y), ramp.right_q14);
}

__attribute__((noinline)) void fill_any(const Wound& w, const DepthTarget& target)
{
    const Rows rows(w, target);
    if (rows.begin >= rows.end) return;
    const Ramp ramp = wide_ramp(w, target);
    if (ramp.kind == Ramp::Kind::none) return;
    Walk left = {0, 0}, right = {0, 0};
    for (int32_t y = rows.begin; y < rows.end; ++y) {
        const bool is_first = y == rows.begin;
        if (is_first || y == rows.bend) set_edges<false>(w, is_first, y >= rows.bend, y, 0, left, right);
        fill_columns(w, ramp, y, {column_of(left, y, target), column_of(right, y, target)}, target);
        left.x_q16 = wrapped_sum(left.x_q16, left.step_q16);
        right.x_q16 = wrapped_sum(right.x_q16, right.step_q16);
    }
}

}  // namespace

template <bool kShifted>
void fill_small_triangle(const ProxyVertex& p, const ProxyVertex& q, const ProxyVertex& r, const DepthTarget& target)
{
    const Wound w = from_top(&p, &q, &r);
    const Rows rows(w, target);
    if (rows.begin >= rows.end) return;
    const Ramp ramp = small_ramp(w, target);
    if (ramp.kind != Ramp::Kind::linear) return fill_any(w, target);
    Descent<kShifted>(ramp, rows.begin, target).fill(w, rows);
}
template void fill_small_triangle<false>(const ProxyVertex&, const ProxyVertex&, const ProxyVertex&,
                                         const DepthTarget&);
template void fill_small_triangle<true>(const ProxyVertex&, const ProxyVertex&, const ProxyVertex&, const DepthTarget&);

void fill_triangle(const ProxyVertex& p, const ProxyVertex& q, const ProxyVertex& r, const DepthTarget& target)
{
    const bool inside = wide_doubled_area(unpacked(p), unpacked(q), unpacked(r)) > 0;
    fill_any(inside ? from_top(&p, &r, &q) : from_top(&p, &q, &r), target);
}

}  // namespace lumi::proxy_math
