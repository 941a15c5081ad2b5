// SPDX-License-Identifier: MIT
#include "surface/fill.h"

#include "surface/gradients.h"

namespace lumi::surfaces
{
namespace
{

// Where an edge crosses the rows, Q16 samples.
struct Walk {
    int32_t x_q16, step_q16;
};

// From the upper end's first row on, which is 0 to 63/64 below it. An edge less than a row high crosses one at most.
LUMI_ALWAYS_INLINE Walk walk_down(const SamplePoint& top, const SamplePoint& bottom, int32_t row)
{
    const int32_t first = row_from(top.y_q6), ahead_q6 = 64 * first + 32 - top.y_q6;
    const int32_t dx_q6 = bottom.x_q6 - top.x_q6, dy_q6 = bottom.y_q6 - top.y_q6;
    const Reciprocal r = reciprocal(static_cast<uint32_t>(dy_q6));
    const int32_t mantissa = static_cast<int32_t>(r.mantissa), shift = 31 - r.leading;
    if (dy_q6 < 64) {
        const int32_t share_q16 = (ahead_q6 * mantissa) >> shift;
        return {top.x_q6 * 1024 + ((dx_q6 * share_q16) >> 6), 0};
    }
    const int32_t step_q16 = (dx_q6 * mantissa) >> shift;
    return {top.x_q6 * 1024 + ((step_q16 * ahead_q6) >> 6) + step_q16 * (row - first), step_q16};
}

// The first sample at a crossing or to its right is the whole part of the crossing plus this.
constexpr int32_t kCentreBias = 0xFFFF - 0x8000;

// Draws the samples [at, end): adds a step to each quantity from sample to sample.
struct Brush {
    uint32_t depth_q14, depth_step;
    uint32_t place, place_step;  // v, u: 6 bits and 10 of fraction each
    PackedColour colour, colour_step;
};

template <bool kTwoTaps>
LUMI_ALWAYS_INLINE void fill_samples(uint16_t* depth_at, const uint16_t* end, PackedColour* colour_at, Brush b,
                                     const Texture& texture, const PackedColour* palette)
{
    // A quarter texel to the lower right, less what would leave the rectangle.
    constexpr uint32_t kQuarter = 250 << 16 | 250;
    const uint8_t* const texels = texture.texels;
    const uint32_t columns = texture.columns;
    do {
        const uint32_t depth = b.depth_q14 >> 14;
        if (depth > *depth_at) {
            *depth_at = static_cast<uint16_t>(depth);
            const auto texel_at = [&](uint32_t place) {
                return palette[texels[(place >> 26) * columns + ((place << 16) >> 26)]];
            };
            PackedColour sum = kTwoTaps ? texel_at(b.place - kQuarter) + texel_at(b.place + kQuarter) + b.colour
                                        : texel_at(b.place) + b.colour;
            if ((sum & kGuardBits) != 0) sum = clamped(sum);
            *colour_at = sum;
        }
        b.depth_q14 += b.depth_step;
        b.place += b.place_step;
        b.colour += b.colour_step;
        ++colour_at;
    } while (++depth_at != end);
}

// A triangle on its way down the target.
template <bool kTwoTaps>
class Descent
{
public:
    LUMI_ALWAYS_INLINE Descent(const Wound& w, const Texture& texture, const Target& target)
        : texture_(texture), target_(target)
    {
        const SamplePoint &top = w.top->point, &left = w.left->point, &right = w.right->point;
        const bool left_is_short = left.y_q6 < right.y_q6;
        const int32_t first = row_from(top.y_q6), below = target.y + target.height;
        const int32_t last = row_from(left_is_short ? right.y_q6 : left.y_q6);
        const int32_t bend = row_from(left_is_short ? left.y_q6 : right.y_q6);
        y_ = first > target.y ? first : target.y;
        const int32_t end = last < below ? last : below;
        if (y_ >= end) return;
        slopes_.set(w);
        begin(w);
        if (y_ < bend) {
            left_ = walk_down(top, left, y_);
            right_ = walk_down(top, right, y_);
            fill_until(bend < end ? bend : end);
            if (bend >= end) return;
            if (left_is_short) {
                left_ = walk_down(left, right, y_);
            } else {
                right_ = walk_down(right, left, y_);
            }
        } else {
            left_ = left_is_short ? walk_down(left, right, y_) : walk_down(top, left, y_);
            right_ = left_is_short ? walk_down(top, right, y_) : walk_down(right, left, y_);
        }
        fill_until(end);
    }

private:
    // Quantities at column 0 of the target, in row y_.
    LUMI_ALWAYS_INLINE void begin(const Wound& w)
    {
        const Corner& top = *w.top;
        const Offset to = {(target_.x << 6) + 32 - top.point.x_q6, (y_ << 6) + 32 - top.point.y_q6};
        depth_q14_ = (top.point.depth << 14) + along(slopes_.depth, to);
        const uint32_t u = static_cast<uint32_t>(top.u_q10) + along(slopes_.u, to);
        const uint32_t v = static_cast<uint32_t>(top.v_q10) + along(slopes_.v, to);
        place_ = (v << 16) + u;
        place_step_ = (static_cast<uint32_t>(slopes_.v.right) << 16) + static_cast<uint32_t>(slopes_.u.right);
        place_down_ = (static_cast<uint32_t>(slopes_.v.down) << 16) + static_cast<uint32_t>(slopes_.u.down);
        colour_q16_[0] = first_colour(red_q2(top.colour), slopes_.colour[0], to);
        colour_q16_[1] = first_colour(green_q2(top.colour), slopes_.colour[1], to);
        colour_q16_[2] = first_colour(blue_q2(top.colour), slopes_.colour[2], to);
        const auto rounded = [](int32_t q16) { return (q16 + (1 << 13)) >> 14; };
        colour_step_ = packed_difference(rounded(slopes_.colour[0].right), rounded(slopes_.colour[1].right),
                                         rounded(slopes_.colour[2].right));
        row_ = (y_ - target_.y) * target_.width;
    }

    LUMI_ALWAYS_INLINE static uint32_t first_colour(int32_t q2, const Slope& slope, const Offset& to)
    {
        return (static_cast<uint32_t>(q2) << 14) + along(slope, to);
    }

    LUMI_ALWAYS_INLINE void fill_until(int32_t end)
    {
        const int32_t bias = kCentreBias - target_.x * 65536;
        do {
            const int32_t from = (left_.x_q16 + bias) >> 16, to = (right_.x_q16 + bias) >> 16;
            const int32_t first = from < 0 ? 0 : from, last = to > target_.width ? target_.width : to;
            if (first < last) fill_row(first, last);
            left_.x_q16 += left_.step_q16;
            right_.x_q16 += right_.step_q16;
            row_ += target_.width;
            depth_q14_ += static_cast<uint32_t>(slopes_.depth.down);
            place_ += place_down_;
            for (int k = 0; k < 3; ++k) colour_q16_[k] += static_cast<uint32_t>(slopes_.colour[k].down);
        } while (++y_ != end);
    }

    // Colours are seated anew every so many samples: a step's rounding of 1/8 level adds up.
    static constexpr int32_t kRun = 32;

    LUMI_ALWAYS_INLINE void fill_row(int32_t from, int32_t to)
    {
        uint32_t column = static_cast<uint32_t>(from);
        Brush brush = {depth_q14_ + column * static_cast<uint32_t>(slopes_.depth.right),
                       static_cast<uint32_t>(slopes_.depth.right),
                       place_ + column * place_step_,
                       place_step_,
                       0,
                       colour_step_};
        while (true) {
            const int32_t end = to - from > kRun ? from + kRun : to;
            brush.colour = colour_at(static_cast<uint32_t>(from));
            fill_samples<kTwoTaps>(target_.depths + row_ + from, target_.depths + row_ + end,
                                   target_.colours + row_ + from, brush, texture_, target_.palette);
            if (end == to) return;
            brush.depth_q14 += kRun * brush.depth_step;
            brush.place += kRun * brush.place_step;
            from = end;
        }
    }

    LUMI_ALWAYS_INLINE PackedColour colour_at(uint32_t column) const
    {
        const auto q2 = [&](int k) {
            return static_cast<int32_t>(colour_q16_[k] + column * static_cast<uint32_t>(slopes_.colour[k].right)) >> 14;
        };
        return packed_difference(q2(0), q2(1), q2(2));
    }

    const Texture& texture_;
    const Target& target_;
    Slopes slopes_;
    Walk left_{0, 0}, right_{0, 0};
    int32_t y_ = 0, row_ = 0;
    uint32_t depth_q14_ = 0, place_ = 0, place_step_ = 0, place_down_ = 0;
    uint32_t colour_q16_[3] = {};
    PackedColour colour_step_ = 0;
};

// Turns a triangle's corners until the upper one is first.
LUMI_ALWAYS_INLINE Wound from_top(const Corner& a, const Corner& b, const Corner& c)
{
    if (b.point.y_q6 < a.point.y_q6 && b.point.y_q6 <= c.point.y_q6) return {&b, &c, &a};
    if (c.point.y_q6 < a.point.y_q6) return {&c, &a, &b};
    return {&a, &b, &c};
}

}  // namespace

void fill_triangle(const Corner& a, const Corner& b, const Corner& c, bool two_sided, const Texture& texture,
                   const Target& target)
{
    const int32_t area = doubled_area(a.point, b.point, c.point);
    if (area == 0 || (area > 0 && !two_sided)) return;
    const Wound w = area < 0 ? from_top(a, b, c) : from_top(a, c, b);
    if (target.has_two_taps) {
        Descent<true>(w, texture, target);
    } else {
        Descent<false>(w, texture, target);
    }
}

}  // namespace lumi::surfaces
