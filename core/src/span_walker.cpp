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

// How often a span must be halved until its end, as far as heights are linear along it, does not cross |z| = limit.
int halvings(int32_t from_z, int32_t next_z, int32_t limit_z)
{
    const bool above = magnitude(from_z) > limit_z;
    int count = 1;
    for (int32_t step = (next_z >> 1) - (from_z >> 1); count <= kMaxSpanLog2; ++count, step /= 2) {
        if ((magnitude(from_z + step) > limit_z) == above) break;
    }
    return count;
}

}  // namespace

void SpanWalker::begin(const SpanNode& at)
{
    const SpanHit& hit = at.*track_.hit;
    longitude_q20_ = static_cast<int32_t>(hit.longitude_turns32 >> 12);
    cap_.triangle = 0;  // a row's picture must not depend on the rows before it
    const SpanChart& chart = track_.chart;
    if (chart.holds(hit.z_q30)) set_begin(chart.at(longitude_q20_, hit.z_q30));
}

int SpanWalker::prepare(const SpanNode& at_node, const SpanNode& next_node, int32_t length)
{
    const SpanHit& at = at_node.*track_.hit;
    const SpanHit& next = next_node.*track_.hit;
    const int32_t next_height = magnitude(next.z_q30);
    const int32_t turn_q20 = static_cast<int32_t>(next.longitude_turns32 - at.longitude_turns32) >> 12;
    next_longitude_q20_ = longitude_q20_ + turn_q20;
    SpanChart& chart = track_.chart;
    SpanSide& side = track_.side;
    if (!chart.holds(at.z_q30)) {
        if (magnitude(at.z_q30) > chart.lattice().cap_z_q30) {
            if (next_height <= chart.lattice().cap_z_q30)
                return halvings(at.z_q30, next.z_q30, chart.lattice().cap_z_q30);
            prepare_cap(at_node, next_node, length);
            return 0;
        }
        chart.choose(at.z_q30, side);
        set_begin(chart.at(longitude_q20_, at.z_q30));
    }
    if (next_height > chart.limit_z_q30()) return halvings(at.z_q30, next.z_q30, chart.limit_z_q30());
    if (magnitude(turn_q20) > kMaxTurnQ20) return magnitude(turn_q20) > 2 * kMaxTurnQ20 ? 2 : 1;
    next_ = chart.at(next_longitude_q20_, next.z_q30);
    const int32_t u_q16 = next_.u_q16 - side.u_q16;
    const int32_t v_q16 = next_.v_q16 - side.v_q16;
    if (!is_steppable(u_q16) || !is_steppable(v_q16)) return 1;
    side.du_q16 = step_of(u_q16, length);
    side.dv_q16 = step_of(v_q16, length);
    // One step on either side changes heights by no more than the whole span does.
    const int32_t reach = magnitude((next.z_q30 >> 1) - (at.z_q30 >> 1));
    const int32_t highest = magnitude(at.z_q30) > next_height ? magnitude(at.z_q30) : next_height;
    may_shift_ = (highest >> 1) + reach < chart.limit_z_q30() >> 1;
    side.z_q30 = at.z_q30;
    side.cap = nullptr;
    side.uniform = chart.is_uniform_at(at.z_q30) && chart.is_uniform_at(next.z_q30);
    return 0;
}

// Leaves the chart behind: the side now counts from the pole.
void SpanWalker::prepare_cap(const SpanNode& at, const SpanNode& next, int32_t length)
{
    const SpanLattice& lattice = track_.chart.lattice();
    const bool mirrored = (at.*track_.hit).z_q30 < 0;
    const SpanNode* nodes[2] = {&at, &next};
    int32_t x[2];
    int32_t y[2];
    for (int k = 0; k < 2; ++k) {
        const SpanHit& hit = nodes[k]->*track_.hit;
        const int32_t scale_q7 = plane_scale_q7(lattice.size, hit.z_q30);
        const int32_t hx = (hit.x_q15 * nodes[k]->inverse_mantissa) >> nodes[k]->shift;
        const int32_t hy = (hit.y_q15 * nodes[k]->inverse_mantissa) >> nodes[k]->shift;
        const int32_t north_x = mirrored ? (hx * lattice.mirror_cos_q15 + hy * lattice.mirror_sin_q15) >> 15 : hx;
        const int32_t north_y = mirrored ? (hx * lattice.mirror_sin_q15 - hy * lattice.mirror_cos_q15) >> 15 : hy;
        x[k] = (north_x * scale_q7) >> 6;  // Q16
        y[k] = (north_y * scale_q7) >> 6;
    }
    track_.chart.leave();
    SpanSide& side = track_.side;
    side.cap = &cap_;
    side.first = mirrored ? -1 : 1;
    side.second = 0;
    side.base = mirrored ? lattice.size - 1 : 0;
    cap_.x_q12 = x[0] >> 4;
    cap_.y_q12 = y[0] >> 4;
    cap_.dx_q16 = step_of(x[1] - x[0], length);
    cap_.dy_q16 = step_of(y[1] - y[0], length);
    cap_.find(0);
}

}  // namespace lumi
