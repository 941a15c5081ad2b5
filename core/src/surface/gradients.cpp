// SPDX-License-Identifier: MIT
#include "surface/gradients.h"

namespace lumi::surfaces
{
namespace
{

// The slopes of the shares that the corners `left` and `right` have in a sample, Q(14 + finer).
struct Shares {
    Slope left, right;
    int32_t finer;  // 0 or 4
};

struct Edge {
    int32_t x_q6, y_q6;
};

LUMI_ALWAYS_INLINE Edge edge(const Corner* from, const Corner* to)
{
    return {to->point.x_q6 - from->point.x_q6, to->point.y_q6 - from->point.y_q6};
}

LUMI_ALWAYS_INLINE int32_t extent(const Edge& e)
{
    const int32_t x = magnitude(e.x_q6), y = magnitude(e.y_q6);
    return x > y ? x : y;
}

// 64·length·reciprocal of an area, Q18.
LUMI_ALWAYS_INLINE int32_t over_area(int32_t length_q6, const Reciprocal& r)
{
    const int32_t product = length_q6 * static_cast<int32_t>(r.mantissa), shift = 23 - r.leading;
    return shift >= 0 ? product >> shift : product * (1 << -shift);
}

// As many bits as keep a share's slope times a depth or a coordinate within 32.
LUMI_ALWAYS_INLINE Shares fitted(const Slope& left_q18, const Slope& right_q18)
{
    const auto fits = [](int32_t v) { return static_cast<uint32_t>(v + (1 << 14)) <= 1u << 15; };
    if (fits(left_q18.right) && fits(left_q18.down) && fits(right_q18.right) && fits(right_q18.down)) {
        return {left_q18, right_q18, 4};
    }
    const auto coarser = [](const Slope& s) { return Slope{s.right >> 4, s.down >> 4}; };
    return {coarser(left_q18), coarser(right_q18), 0};
}

// A triangle less than a sample thick is taken for its longest edge.
__attribute__((noinline)) Shares shares_of_sliver(const Edge& to_left, const Edge& to_right)
{
    const Edge between = {to_right.x_q6 - to_left.x_q6, to_right.y_q6 - to_left.y_q6};
    const int32_t left = extent(to_left), right = extent(to_right), across = extent(between);
    const Edge longest = left >= right && left >= across ? to_left : right >= across ? to_right : between;
    const uint32_t length2 =
        static_cast<uint32_t>(longest.x_q6 * longest.x_q6) + static_cast<uint32_t>(longest.y_q6 * longest.y_q6);
    if (length2 < 1 << 12) return {{0, 0}, {0, 0}, 0};  // shorter than a sample
    const Reciprocal r = reciprocal(length2);
    const Slope rise = {over_area(longest.x_q6, r), over_area(longest.y_q6, r)}, none = {0, 0};
    if (left >= right && left >= across) return fitted(rise, none);
    if (right >= across) return fitted(none, rise);
    // From `left` to `right`; the corner at the top lies on that edge, to less than a sample.
    const Slope fall = {-rise.right, -rise.down};
    return fitted(fall, rise);
}

LUMI_ALWAYS_INLINE Shares shares_of(const Wound& w)
{
    const Edge left = edge(w.top, w.left), right = edge(w.top, w.right);
    const uint32_t area = static_cast<uint32_t>(right.x_q6 * left.y_q6 - left.x_q6 * right.y_q6);
    const int32_t longer = extent(left) > extent(right) ? extent(left) : extent(right);
    if (area < static_cast<uint32_t>(longer + (longer >> 1)) << 6) return shares_of_sliver(left, right);
    const Reciprocal r = reciprocal(area);
    return fitted({-over_area(right.y_q6, r), over_area(right.x_q6, r)},
                  {over_area(left.y_q6, r), -over_area(left.x_q6, r)});
}

// Of a quantity that rises by so much from the top to the left and to the right corner.
LUMI_ALWAYS_INLINE Slope slope(const Shares& s, int32_t to_left, int32_t to_right, int32_t drop)
{
    return {(s.left.right * to_left + s.right.right * to_right) >> drop,
            (s.left.down * to_left + s.right.down * to_right) >> drop};
}

}  // namespace

void Slopes::set(const Wound& w)
{
    const Shares s = shares_of(w);
    const Corner &top = *w.top, &left = *w.left, &right = *w.right;
    depth = slope(s, static_cast<int32_t>(left.point.depth - top.point.depth),
                  static_cast<int32_t>(right.point.depth - top.point.depth), s.finer);
    u = slope(s, left.u_q10 - top.u_q10, right.u_q10 - top.u_q10, 14 + s.finer);
    v = slope(s, left.v_q10 - top.v_q10, right.v_q10 - top.v_q10, 14 + s.finer);
    const auto rise = [&](int32_t (*channel)(uint32_t)) {
        const int32_t from = channel(top.colour);
        return slope(s, channel(left.colour) - from, channel(right.colour) - from, s.finer);
    };
    colour[0] = rise(red_q2);
    colour[1] = rise(green_q2);
    colour[2] = rise(blue_q2);
}

}  // namespace lumi::surfaces
