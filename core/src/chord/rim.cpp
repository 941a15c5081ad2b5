// SPDX-License-Identifier: MIT
#include "lumi/detail/chord/rim.h"

#include "lumi/detail/register_hints.h"
#include "lumi/math.h"

namespace lumi
{
namespace
{

constexpr int32_t kLeastSpacingQ15 = 1 << 8;
constexpr int32_t kSlopeLimitQ5 = 1 << 14;

bool is_slope(int32_t v_q5)
{
    return magnitude(v_q5) < kSlopeLimitQ5;
}

// difference/spacing; both factors stay below 2^15.
int32_t slope_q5(int32_t difference_q16, const CoarseReciprocal& inverse)
{
    return ((difference_q16 >> 6) * inverse.mantissa) >> (inverse.exponent - 11);
}

// Newton's form of the parabola through three knots, moved to the middle one.
bool fit_row(const LatticePoint at[3], int32_t LatticePoint::*of, const RimSpacing& spacing, RimParabola& p)
{
    const int32_t outer_q16 = at[1].*of - at[0].*of;
    const int32_t inner_q16 = at[2].*of - at[1].*of;
    if (!is_steppable(outer_q16) || !is_steppable(inner_q16)) return false;
    const int32_t outer_q5 = slope_q5(outer_q16, spacing.outer);
    const int32_t inner_q5 = slope_q5(inner_q16, spacing.inner);
    if (!is_slope(outer_q5) || !is_slope(inner_q5)) return false;
    const int32_t bend_q5 = ((inner_q5 - outer_q5) * spacing.both.mantissa) >> (spacing.both.exponent - 15);
    if (!is_slope(bend_q5)) return false;
    const int32_t slope_q5 = outer_q5 + ((bend_q5 * spacing.outer_q15) >> 15);
    p = {at[1].*of, static_cast<int16_t>(slope_q5), static_cast<int16_t>(bend_q5)};
    return is_slope(slope_q5);
}

bool fit_rows(const LatticePoint at[2][3], int32_t LatticePoint::*of, const RimSpacing spacing[2], RimRows& rows)
{
    RimParabola bottom;
    if (!fit_row(at[0], of, spacing[0], rows.top) || !fit_row(at[1], of, spacing[1], bottom)) return false;
    rows.rise = {bottom.value_q16 - rows.top.value_q16, static_cast<int16_t>(bottom.slope_q5 - rows.top.slope_q5),
                 static_cast<int16_t>(bottom.bend_q5 - rows.top.bend_q5)};
    return true;
}

bool is_far(uint32_t turns32)
{
    return magnitude(static_cast<int32_t>(turns32) >> 12) > kMaxTurnQ20;
}

bool set_spacing(const int32_t half_chord_q15[3], RimSpacing& spacing)
{
    const int32_t outer_q15 = half_chord_q15[1] - half_chord_q15[0];
    const int32_t inner_q15 = half_chord_q15[2] - half_chord_q15[1];
    if (outer_q15 < kLeastSpacingQ15 || inner_q15 < kLeastSpacingQ15) return false;
    const auto inverse = [](int32_t v) { return coarse_reciprocal(static_cast<uint32_t>(v)); };
    spacing = {outer_q15, inverse(outer_q15), inverse(inner_q15), inverse(outer_q15 + inner_q15)};
    return true;
}

LUMI_ALWAYS_INLINE int32_t between(int32_t top, int32_t rise, int32_t row)
{
    return top + ((rise * row) >> kTileRowsLog2);
}

int32_t smaller(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

int32_t larger(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

}  // namespace

void RimRows::go_to(int32_t row_of_tile)
{
    row.value_q16 = between(top.value_q16, rise.value_q16, row_of_tile);
    row.slope_q5 = static_cast<int16_t>(between(top.slope_q5, rise.slope_q5, row_of_tile));
    row.bend_q5 = static_cast<int16_t>(between(top.bend_q5, rise.bend_q5, row_of_tile));
}

bool RimCurve::begin(const SpanNode& middle)
{
    const SpanHit& hit = middle.*track_.hit;
    SpanChart& chart = track_.chart;
    if (!chart.holds(hit.z_q30)) {
        if (magnitude(hit.z_q30) > chart.lattice().cap_z_q30) return false;
        chart.choose(hit.z_q30, track_.side);
    }
    track_.side.cap = nullptr;
    track_.side.uniform = true;
    longitude_turns32_ = hit.longitude_turns32;
    return true;
}

bool RimCurve::place(const SpanNode& node, LatticePoint& at)
{
    constexpr int32_t kMostTurnQ20 = 3 * kMaxTurnQ20 / 2;
    const SpanHit& hit = node.*track_.hit;
    const SpanChart& chart = track_.chart;
    const int32_t turn_q20 = static_cast<int32_t>(hit.longitude_turns32 - longitude_turns32_) >> 12;
    at = chart.at((static_cast<int32_t>(longitude_turns32_ >> 12)) + turn_q20, hit.z_q30 >> 14);
    track_.side.uniform = track_.side.uniform && chart.is_uniform_at(hit.z_q30);
    return magnitude(turn_q20) <= kMostTurnQ20;
}

bool RimCurve::fit(const LatticePoint at[2][3], const RimSpacing spacing[2], const RimReach& reach)
{
    return fit_rows(at, &LatticePoint::u_q16, spacing, u_) && fit_rows(at, &LatticePoint::v_q16, spacing, v_) &&
           stays_in_chart(reach);
}

// Whether all cells that the rim may reach are the chart's. The sum of a place's coordinates by their steps is a
// real-valued index: of each row it is a parabola too, and between both rows it lies between theirs.
bool RimCurve::stays_in_chart(const RimReach& reach)
{
    const SpanSide& side = track_.side;
    const auto index_q8 = [&](int32_t u_q16, int32_t v_q16) {
        return side.first * (u_q16 >> 8) + side.second * (v_q16 >> 8);
    };
    int32_t lowest = INT32_MAX;
    int32_t highest = INT32_MIN;
    int32_t bow = 0;
    for (int32_t row = 0; row <= kTileRows; row += kTileRows) {
        u_.go_to(row);
        v_.go_to(row);
        const RimParabola& u = u_.row;
        const RimParabola& v = v_.row;
        const int32_t low = index_q8(u.at(reach.low_q15), v.at(reach.low_q15));
        const int32_t high = index_q8(u.at(reach.high_q15), v.at(reach.high_q15));
        lowest = smaller(lowest, smaller(low, high));
        highest = larger(highest, larger(low, high));
        // A parabola rises above its chord by a quarter of the bend times the chord's square.
        const uint32_t bend_q5 = static_cast<uint32_t>(magnitude(side.first * u.bend_q5 + side.second * v.bend_q5));
        const auto width_q15 = static_cast<uint32_t>(reach.high_q15 - reach.low_q15);
        bow = larger(bow, static_cast<int32_t>(((bend_q5 >> 8) + 1) * ((width_q15 * width_q15) >> 15) >> 7));
    }
    // Spans are moved by less than an eighth of their length.
    const int32_t beyond = bow + ((highest - lowest + 2 * bow) >> 3);
    const int32_t steps = magnitude(side.first) + magnitude(side.second);
    const int32_t first = (steps + 2) << 8;
    const int32_t last = (track_.chart.lattice().size - 1 - steps - 2) << 8;
    const int32_t base = side.base << 8;
    return base + lowest - beyond >= first && base + highest + beyond <= last;
}

void RimCurve::begin_row(int32_t row_of_tile, int32_t d_q15)
{
    u_.go_to(row_of_tile);
    v_.go_to(row_of_tile);
    next_ = {u_.row.at(d_q15), v_.row.at(d_q15)};
}

void RimCurve::prepare_span(int32_t d_q15, int32_t length, int32_t share_q8)
{
    SpanSide& side = track_.side;
    const LatticePoint from = next_;
    next_ = {u_.row.at(d_q15), v_.row.at(d_q15)};
    side.du_q16 = step_of(next_.u_q16 - from.u_q16, length);
    side.dv_q16 = step_of(next_.v_q16 - from.v_q16, length);
    side.u_q16 = from.u_q16 + ((side.du_q16 * share_q8) >> 8);
    side.v_q16 = from.v_q16 + ((side.dv_q16 * share_q8) >> 8);
    // Of a real-valued index i: 1 - 2·i/n, near enough for a metric.
    const int32_t index_q4 = (side.base << 4) + side.first * (side.u_q16 >> 12) + side.second * (side.v_q16 >> 12);
    side.z_q30 = kOneQ30 - 2 * index_q4 * (track_.chart.lattice().step_z_q30 >> 4);
}

// Pixels of both rows, from the outline inwards: next to it, a quarter of the way, at the tiles.
struct SpanRim::Knots {
    RayRow rays[2];
    int32_t ahead_px[2][3];
};

bool SpanRim::prepare(const NodeEvaluator& nodes, const RayRow& rays, const int32_t outer_px[2])
{
    constexpr int32_t kLeastWidth = 4;
    Knots knots;
    RimSpacing spacing[2];
    int32_t s_q15[2][3];
    for (int row = 0; row < 2; ++row) {
        const int32_t outer = outer_px[row];
        if (magnitude(outer) < kLeastWidth) return false;
        const int32_t quarter = (magnitude(outer) + 2) >> 2;
        knots.rays[row] = nodes.moved(rays, 0, row * kTileRows);
        knots.ahead_px[row][0] = outer;
        knots.ahead_px[row][1] = outer < 0 ? outer + quarter : outer - quarter;
        knots.ahead_px[row][2] = 0;
        for (int k = 0; k < 3; ++k) s_q15[row][k] = nodes.half_chord_q15(knots.rays[row], knots.ahead_px[row][k]);
        if (!set_spacing(s_q15[row], spacing[row])) return false;
    }
    top_q15_ = s_q15[0][1];
    rise_q15_ = s_q15[1][1] - top_q15_;
    // The outline's and the tiles' pixels lie next to the knots of these rows, or between them.
    constexpr int32_t kSlackQ15 = 1 << 10;
    reach_ = {-larger(s_q15[0][1], s_q15[1][1]),
              larger(s_q15[0][2] - s_q15[0][1], s_q15[1][2] - s_q15[1][1]) + kSlackQ15};
    return place(nodes, knots, spacing);
}

bool SpanRim::place(const NodeEvaluator& nodes, const Knots& knots, const RimSpacing spacing[2])
{
    static constexpr int kOrder[] = {1, 0, 2};  // the middle one chooses the chart
    SpanNode node;
    LatticePoint front[2][3];
    LatticePoint back[2][3];
    turns_far_ = false;
    for (int row = 0; row < 2; ++row) {
        uint32_t front_turns32 = 0;  // longitudes next to the outline
        uint32_t back_turns32 = 0;
        for (const int k : kOrder) {
            nodes.evaluate(knots.rays[row], knots.ahead_px[row][k], node);
            if (row == 0 && k == 1 && !(front_.begin(node) && back_.begin(node))) return false;
            if (!front_.place(node, front[row][k]) || !back_.place(node, back[row][k])) return false;
            if (k > 0) continue;
            front_turns32 = node.front.longitude_turns32;
            back_turns32 = node.back.longitude_turns32;
        }
        if (is_far(node.front.longitude_turns32 - front_turns32)) turns_far_ = true;
        if (is_far(node.back.longitude_turns32 - back_turns32)) turns_far_ = true;
    }
    return front_.fit(front, spacing, reach_) && back_.fit(back, spacing, reach_);
}

int32_t SpanRim::from_middle_q15(int32_t half_chord_q15) const
{
    const int32_t d = half_chord_q15 - middle_q15_;
    return d < reach_.low_q15 ? reach_.low_q15 : d < reach_.high_q15 ? d : reach_.high_q15;
}

void SpanRim::begin_row(int32_t row_of_tile, int32_t half_chord_q15)
{
    middle_q15_ = between(top_q15_, rise_q15_, row_of_tile);
    const int32_t d = from_middle_q15(half_chord_q15);
    front_.begin_row(row_of_tile, d);
    back_.begin_row(row_of_tile, d);
}

void SpanRim::prepare_span(int32_t half_chord_q15, int32_t length, int32_t share_q8)
{
    const int32_t d = from_middle_q15(half_chord_q15);
    front_.prepare_span(d, length, share_q8);
    back_.prepare_span(d, length, share_q8);
}

}  // namespace lumi
