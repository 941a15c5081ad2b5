// SPDX-License-Identifier: MIT
#include "lumi/span_walker.h"

#include "lumi/math.h"

namespace lumi
{
namespace
{

// The scale of the polar pattern's plane at height z: sqrt(n/(2·(1 + |z|))), Q7.
int32_t plane_scale_q7(int32_t n, int32_t z_q30)
{
    const uint32_t z_q15 = static_cast<uint32_t>(magnitude(z_q30)) >> 15;
    const CoarseReciprocal r = coarse_reciprocal(2 * (32768 + z_q15));  // about 2^17
    // n/(2(1 + |z|)) < 2^15 in Q14, whose root is Q7 where coarse_root_q15 takes Q30 to Q15.
    const uint32_t scale2_q14 = (static_cast<uint32_t>(n) * static_cast<uint32_t>(r.mantissa)) >> (r.exponent - 29);
    return coarse_root_q15(scale2_q14);
}

// How many of a span's pixels lie on this side of |z| = limit, as far as heights are linear along it: 0 .. length - 1.
int32_t length_before(int32_t limit, int32_t from_height, int32_t next_height, int32_t length)
{
    const auto way = [&](int32_t to) { return static_cast<uint32_t>(magnitude(to - from_height)) >> 14; };
    const uint32_t whole = way(next_height) + 1;
    const uint32_t part = way(limit) < whole ? way(limit) : whole;
    const int32_t before = static_cast<int32_t>((static_cast<uint32_t>(length) * ratio_q15(part, whole)) >> 15);
    return before < length ? before : length - 1;
}

}  // namespace

void SpanWalker::begin(const SpanNode& at)
{
    const SpanHit& hit = at.*track_.hit;
    longitude_q20_ = static_cast<int32_t>(hit.longitude_turns32 >> 12);
    track_.side.cap = nullptr;
    cap_.triangle = 0;  // a row's picture must not depend on the rows before it
    const SpanChart& chart = track_.chart;
    if (chart.holds(hit.z_q30)) set_begin(chart.at(longitude_q20_, hit.z_q30));
}

int32_t SpanWalker::prepare(const SpanNode& at_node, const SpanNode& next_node, int32_t length)
{
    const SpanHit& at = at_node.*track_.hit;
    const SpanHit& next = next_node.*track_.hit;
    const int32_t height = magnitude(at.z_q30);
    const int32_t next_height = magnitude(next.z_q30);
    const int32_t turn_q20 = static_cast<int32_t>(next.longitude_turns32 - at.longitude_turns32) >> 12;
    next_longitude_q20_ = longitude_q20_ + turn_q20;
    SpanChart& chart = track_.chart;
    SpanSide& side = track_.side;
    if (!chart.holds(at.z_q30)) {
        if (height > chart.lattice().cap_z_q30) {
            if (reaches_cap(at, next)) return prepare_cap(at_node, next_node, length);
            return length_before(chart.lattice().reach_z_q30, height, next_height, length);
        }
        chart.choose(at.z_q30, side);
        side.cap = nullptr;
        set_begin(chart.at(longitude_q20_, at.z_q30));
    }
    if (next_height > chart.limit_z_q30()) {
        if (reaches_cap(at, next)) return prepare_cap(at_node, next_node, length);
        return length_before(chart.limit_z_q30(), height, next_height, length);
    }
    if (magnitude(turn_q20) > kMaxTurnQ20) return magnitude(turn_q20) > 2 * kMaxTurnQ20 ? length >> 2 : length >> 1;
    next_ = chart.at(next_longitude_q20_, next.z_q30);
    const int32_t u_q16 = next_.u_q16 - side.u_q16;
    const int32_t v_q16 = next_.v_q16 - side.v_q16;
    if (!is_steppable(u_q16) || !is_steppable(v_q16)) return length >> 1;
    side.du_q16 = step_of(u_q16, length);
    side.dv_q16 = step_of(v_q16, length);
    side.z_q30 = at.z_q30;
    next_z_q30_ = next.z_q30;
    side.uniform = chart.is_uniform_at(at.z_q30) && chart.is_uniform_at(next.z_q30);
    return length;
}

void SpanWalker::shift(int32_t share_q8)
{
    SpanSide& side = track_.side;
    if (side.cap != nullptr) return;
    // One step on either side changes heights by no more than the whole span does.
    const int32_t reach = magnitude((next_z_q30_ >> 1) - (side.z_q30 >> 1));
    const int32_t height = magnitude(side.z_q30);
    const int32_t next_height = magnitude(next_z_q30_);
    const int32_t highest = height > next_height ? height : next_height;
    if ((highest >> 1) + reach >= track_.chart.limit_z_q30() >> 1) return;
    side.u_q16 += (side.du_q16 * share_q8) >> 8;
    side.v_q16 += (side.dv_q16 * share_q8) >> 8;
}

// A hit's place in the polar pattern's plane, Q16.
LatticePoint SpanWalker::in_plane(const SpanNode& node, bool mirrored) const
{
    const SpanLattice& lattice = track_.chart.lattice();
    const SpanHit& hit = node.*track_.hit;
    const int32_t scale_q7 = plane_scale_q7(lattice.size, hit.z_q30);
    const int32_t x = (hit.x_q15 * node.inverse_mantissa) >> node.shift;
    const int32_t y = (hit.y_q15 * node.inverse_mantissa) >> node.shift;
    const int32_t north_x = mirrored ? (x * lattice.mirror_cos_q15 + y * lattice.mirror_sin_q15) >> 15 : x;
    const int32_t north_y = mirrored ? (x * lattice.mirror_sin_q15 - y * lattice.mirror_cos_q15) >> 15 : y;
    return {(north_x * scale_q7) >> 6, (north_y * scale_q7) >> 6};
}

// Whether the polar pattern holds both hits.
bool SpanWalker::reaches_cap(const SpanHit& at, const SpanHit& next) const
{
    const int32_t reach = track_.chart.lattice().reach_z_q30;
    return at.z_q30 >= reach ? next.z_q30 >= reach : at.z_q30 <= -reach && next.z_q30 <= -reach;
}

// Leaves the chart behind: the side now counts from the pole, and its coordinates are places in the plane.
int32_t SpanWalker::prepare_cap(const SpanNode& at, const SpanNode& next, int32_t length)
{
    SpanSide& side = track_.side;
    const bool mirrored = (at.*track_.hit).z_q30 < 0;
    if (side.cap == nullptr) {
        track_.chart.leave();
        side.cap = &cap_;
        side.first = mirrored ? -1 : 1;
        side.second = 0;
        side.base = mirrored ? track_.chart.lattice().size - 1 : 0;
        set_begin(in_plane(at, mirrored));
    }
    next_ = in_plane(next, mirrored);
    cap_.x_q12 = side.u_q16 >> 4;
    cap_.y_q12 = side.v_q16 >> 4;
    cap_.dx_q16 = step_of(next_.u_q16 - side.u_q16, length);
    cap_.dy_q16 = step_of(next_.v_q16 - side.v_q16, length);
    cap_.find(0);
    return length;
}

}  // namespace lumi
