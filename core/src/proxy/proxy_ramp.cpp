// SPDX-License-Identifier: MIT
#include "proxy/proxy_ramp.h"

namespace lumi::proxy_math
{
namespace
{

constexpr uint32_t kTinyArea = 1 << 13;  // Q12: two samples doubled; products with depths fit 32 bits
constexpr int32_t kMaxStep = 1 << 29;    // Q14
constexpr int kStepBits = 20;            // 14 of a step, 6 of a length that a sample is

// What the corners' depths rise over the top one's, and where they lie from there.
struct Spread {
    int32_t left_rise, left_x, left_y;
    int32_t right_rise, right_x, right_y;

    LUMI_ALWAYS_INLINE explicit Spread(const Wound& w)
        : left_rise(w.left.depth - w.top.depth),
          left_x(w.left.x_q6 - w.top.x_q6),
          left_y(w.left.y_q6 - w.top.y_q6),
          right_rise(w.right.depth - w.top.depth),
          right_x(w.right.x_q6 - w.top.x_q6),
          right_y(w.right.y_q6 - w.top.y_q6)
    {
    }
};

template <class Int>
LUMI_ALWAYS_INLINE Int determinant(Int a, Int b, Int c, Int d)
{
    return a * d - b * c;
}

LUMI_ALWAYS_INLINE Ramp linear_ramp(int32_t right_q14, int32_t down_q14, const SamplePoint& top,
                                    const DepthTarget& target)
{
    const uint32_t right = static_cast<uint32_t>(right_q14), down = static_cast<uint32_t>(down_q14);
    const auto rest = [](int32_t v_q6) { return v_q6 & 63; };
    const int32_t column = (top.x_q6 >> 6) - target.x, row = top.y_q6 >> 6;
    const int32_t right_q8 = right_q14 >> 6;
    const uint32_t corner = (static_cast<uint32_t>(top.depth) << 14) - right * static_cast<uint32_t>(column) -
                            down * static_cast<uint32_t>(row) +
                            static_cast<uint32_t>((down_q14 >> 6) * (32 - rest(top.y_q6)));
    const auto base = [&](int32_t phase_q6) {
        return corner + static_cast<uint32_t>(right_q8 * (phase_q6 - rest(top.x_q6)));
    };
    return {Ramp::Kind::linear, right, down, {base(target.phase_q6[0]), base(target.phase_q6[1])}};
}

LUMI_ALWAYS_INLINE Ramp without_steps(bool has_area)
{
    return {has_area ? Ramp::Kind::exact : Ramp::Kind::none, 0, 0, {0, 0}};
}

int32_t rounded_ratio(int64_t over, int64_t under)
{
    return static_cast<int32_t>((over < 0 ? over - under / 2 : over + under / 2) / under);
}

}  // namespace

Ramp small_ramp(const Wound& w, const DepthTarget& target)
{
    const Spread p(w);
    const uint32_t area = static_cast<uint32_t>(determinant(p.right_x, p.right_y, p.left_x, p.left_y));
    if (area < kTinyArea) return without_steps(area != 0);
    const int32_t right = determinant(p.right_rise, p.right_y, p.left_rise, p.left_y);
    const int32_t down = determinant(p.right_x, p.right_rise, p.left_x, p.left_rise);
    const Reciprocal r = reciprocal(area);
    const int32_t right_step = times_q16(right, r.mantissa), down_step = times_q16(down, r.mantissa);
    const int32_t left = r.leading - (31 - kStepBits);
    if (left <= 0) return linear_ramp(right_step >> -left, down_step >> -left, w.top, target);
    const int32_t most = kMaxStep >> left;
    const auto fits = [&](int32_t step) {
        return static_cast<uint32_t>(step + most) <= 2u * static_cast<uint32_t>(most);
    };
    if (!fits(right_step) || !fits(down_step)) return without_steps(true);
    return linear_ramp(right_step * (1 << left), down_step * (1 << left), w.top, target);
}

Ramp wide_ramp(const Wound& w, const DepthTarget& target)
{
    const Spread p(w);
    const int64_t area = determinant<int64_t>(p.right_x, p.right_y, p.left_x, p.left_y);
    const int64_t right = determinant<int64_t>(p.right_rise, p.right_y, p.left_rise, p.left_y);
    const int64_t down = determinant<int64_t>(p.right_x, p.right_rise, p.left_x, p.left_rise);
    const auto fits = [&](int64_t n) { return (n < 0 ? -n : n) >> (29 - kStepBits) < area; };
    if (!fits(right) || !fits(down)) return without_steps(area != 0);
    const auto step = [&](int64_t n) { return rounded_ratio(n * (1 << kStepBits), area); };
    return linear_ramp(step(right), step(down), w.top, target);
}

int32_t exact_depth(const Wound& w, int32_t x_q6, int32_t y_q6)
{
    const Spread p(w);
    const int32_t right = x_q6 - w.top.x_q6, down = y_q6 - w.top.y_q6;
    const int64_t area = wide_product(p.right_x, p.left_y) - wide_product(p.left_x, p.right_y);
    const int64_t of_right = wide_product(right, p.left_y) - wide_product(p.left_x, down);
    const int64_t of_left = wide_product(p.right_x, down) - wide_product(right, p.right_y);
    const int64_t rise = of_right * p.right_rise + of_left * p.left_rise;
    int32_t depth = w.top.depth;
    if (area >= kTinyArea) {
        depth += static_cast<int32_t>(rise / area);
    } else {
        const Reciprocal r = reciprocal(static_cast<uint32_t>(area));
        depth += times_q16(static_cast<int32_t>(rise), r.mantissa) >> (31 - r.leading);
    }
    // Samples may lie outside by what an edge's rounding is.
    const int32_t least = least_of(w.top.depth, w.left.depth, w.right.depth);
    const int32_t most = most_of(w.top.depth, w.left.depth, w.right.depth);
    return depth < least ? least : depth > most ? most : depth;
}

}  // namespace lumi::proxy_math
