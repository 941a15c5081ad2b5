// SPDX-License-Identifier: MIT
#include "lumi/detail/stepping/walker.h"

#include "lumi/math.h"

namespace lumi
{
namespace
{

// How many of a span's pixels lie on this side of a height, as far as heights are linear along it: 0 .. length - 1.
int32_t length_before(int32_t limit_z_q30, int32_t from_z_q30, int32_t next_z_q30, int32_t length)
{
    const auto way = [&](int32_t to) { return static_cast<uint32_t>(magnitude((to >> 1) - (from_z_q30 >> 1))) >> 13; };
    const int32_t limit = limit_z_q30;
    const uint32_t whole = way(next_z_q30) + 1;
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
    track_.cap.triangle = 0;  // a row's picture must not depend on the rows before it
    const SpanChart& chart = track_.chart;
    if (chart.holds(hit.z_q30)) set_begin(chart.at(longitude_q20_, hit.z_q30 >> 14));
}

int32_t SpanWalker::prepare(const SpanNode& at_node, const SpanNode& next_node, int32_t length)
{
    const SpanHit& at = at_node.*track_.hit;
    const SpanHit& next = next_node.*track_.hit;
    const int32_t turn_q20 = static_cast<int32_t>(next.longitude_turns32 - at.longitude_turns32) >> 12;
    next_longitude_q20_ = longitude_q20_ + turn_q20;
    SpanChart& chart = track_.chart;
    SpanSide& side = track_.side;
    if (!chart.holds(at.z_q30)) {
        const int32_t height = magnitude(at.z_q30);
        if (height > chart.lattice().cap_z_q30) {
            if (reaches_cap(at, next)) return prepare_cap(at_node, next_node, length);
            return length_before(chart.lattice().reach_z_q30, height, magnitude(next.z_q30), length);
        }
        chart.choose(at.z_q30, side);
        side.cap = nullptr;
        set_begin(chart.at(longitude_q20_, at.z_q30 >> 14));
    }
    if (!chart.reaches(next.z_q30)) {
        if (reaches_cap(at, next)) return prepare_cap(at_node, next_node, length);
        const int32_t limit = next.z_q30 < chart.lowest_z_q30() ? chart.lowest_z_q30() : chart.highest_z_q30();
        return length_before(limit, at.z_q30, next.z_q30, length);
    }
    if (magnitude(turn_q20) > kMaxTurnQ20) return magnitude(turn_q20) > 2 * kMaxTurnQ20 ? length >> 2 : length >> 1;
    next_ = chart.at(next_longitude_q20_, next.z_q30 >> 14);
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
    // A share is below an eighth of the span's length: it changes heights by less than an eighth of what the span does.
    const SpanChart& chart = track_.chart;
    const int32_t z_q29 = side.z_q30 >> 1;
    const int32_t next_z_q29 = next_z_q30_ >> 1;
    const int32_t reach = magnitude(next_z_q29 - z_q29) >> 3;
    const int32_t lowest = (z_q29 < next_z_q29 ? z_q29 : next_z_q29) - reach;
    const int32_t highest = (z_q29 < next_z_q29 ? next_z_q29 : z_q29) + reach;
    if (lowest <= chart.lowest_z_q30() >> 1 || highest >= chart.highest_z_q30() >> 1) return;
    side.u_q16 += (side.du_q16 * share_q8) >> 8;
    side.v_q16 += (side.dv_q16 * share_q8) >> 8;
}

// Whether the polar pattern holds both hits.
bool SpanWalker::reaches_cap(const SpanHit& at, const SpanHit& next) const
{
    const int32_t reach = track_.chart.lattice().reach_z_q30;
    return at.z_q30 >= reach ? next.z_q30 >= reach : at.z_q30 <= -reach && next.z_q30 <= -reach;
}

int32_t SpanWalker::prepare_cap(const SpanNode& at, const SpanNode& next, int32_t length)
{
    SpanSide& side = track_.side;
    const bool mirrored = (at.*track_.hit).z_q30 < 0;
    if (side.cap == nullptr) {
        track_.enter_cap(mirrored);
        set_begin(track_.in_plane(at, mirrored));
    }
    next_ = track_.in_plane(next, mirrored);
    side.du_q16 = step_of(next_.u_q16 - side.u_q16, length);
    side.dv_q16 = step_of(next_.v_q16 - side.v_q16, length);
    track_.follow_cap();
    return length;
}

}  // namespace lumi
