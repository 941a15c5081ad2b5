// SPDX-License-Identifier: MIT
#include "lumi/span_kernel.h"

#include "polar.h"

namespace lumi
{
namespace
{

constexpr int32_t kInverseRoot5Q15 = 14654;  // 1/√5
constexpr int32_t kPhiQ12 = 6627;
constexpr int32_t kInversePhiQ12 = 2531;
constexpr int32_t kPhi2Q12 = 10723;
constexpr int32_t kInversePhi2Q12 = 1565;
constexpr int32_t kOneQ12 = 4096;

int32_t over_root5(int32_t v_q12)
{
    return (v_q12 * kInverseRoot5Q15) >> 15;
}

uint32_t sine2_q15(int32_t z_q30)
{
    const int32_t z_q15 = z_q30 >> 15;
    return 32768u - (static_cast<uint32_t>(z_q15 * z_q15) >> 15);
}

// X and 1/X, Q12, kept within the zone.
struct Shape {
    int32_t x_q12, inverse_q12;

    explicit Shape(const SpanSide& side)
    {
        const uint32_t here = sine2_q15(side.z_q30);
        const uint32_t begin = sine2_q15(side.zone->begin_z_q30);
        const CoarseReciprocal r = coarse_reciprocal(begin != 0 ? begin : 1);
        const int32_t x = static_cast<int32_t>((here * static_cast<uint32_t>(r.mantissa)) >> (r.exponent - 12));
        x_q12 = x < kOneQ12 ? kOneQ12 : x > kPhi2Q12 ? kPhi2Q12 : x;
        const CoarseReciprocal i = coarse_reciprocal(static_cast<uint32_t>(x_q12));
        inverse_q12 = i.mantissa >> (i.exponent - 24);
    }
};

}  // namespace

SpanMetric::SpanMetric(const SpanSide& side) : e_q12(0), f_q12(0), g_q12(0)
{
    if (side.cap != nullptr) return;
    const Shape shape(side);
    e_q12 = over_root5(shape.x_q12 + shape.inverse_q12);
    g_q12 = over_root5((shape.x_q12 * kInversePhi2Q12 + shape.inverse_q12 * kPhi2Q12) >> 12);
    const int32_t f = over_root5((shape.inverse_q12 * kPhiQ12 - shape.x_q12 * kInversePhiQ12) >> 12);
    f_q12 = side.reflected() ? -f : f;
}

// The corners of the cap's triangle and the points across its edges, at their distances in Lambert's plane, where a
// point covers an area of π and the mean spacing is √π.
SpanNeighbours KernelSource::cap_neighbours() const
{
    constexpr int32_t kInversePiQ15 = 10430;
    SpanNeighbours result;
    const int32_t x = cap_->x_q12 + ((pixel_ * cap_->dx_q16) >> 4);
    const int32_t y = cap_->y_q12 + ((pixel_ * cap_->dy_q16) >> 4);
    const uint8_t* beyond = polar::beyond(cap_->triangle);
    const uint8_t* own = polar::corners(cap_->triangle);
#pragma GCC unroll 6
    for (int k = 0; k < kKernelCandidates; ++k) {  // unrolled: nothing is divided by 3
        int32_t corner = own[k % 3];
        if (k >= 3 && beyond[k - 3] != polar::kNone) {
            const uint8_t* c = polar::corners(beyond[k - 3]);
            const int32_t a = own[(k + 1) % 3];
            const int32_t b = own[(k + 2) % 3];
            corner = c[0] != a && c[0] != b ? c[0] : c[1] != a && c[1] != b ? c[1] : c[2];
        }
        const polar::PlanePoint p = polar::plane_point(static_cast<uint32_t>(corner));
        const int32_t dx = (p.x_q12 - x) >> 2;
        const int32_t dy = (p.y_q12 - y) >> 2;
        const bool doubled = k >= 3 && beyond[k - 3] == polar::kNone;
        const int32_t distance2_q12 = (((dx * dx + dy * dy) >> 8) * kInversePiQ15) >> 15;
        result.offset[k] = corner * steps_.first;
        result.distance2_q12[k] = doubled ? kOneQ12 : distance2_q12;
    }
    return result;
}

KernelTaps::KernelTaps(const SpanNeighbours& near, uint32_t most, const OffsetRange& range, int bits) : count(0)
{
    uint32_t sum = 0;
    int found = 0;
#pragma GCC unroll 6
    for (int k = 0; k < kKernelCandidates; ++k) {
        const int32_t inside = kOneQ12 - near.distance2_q12[k];
        if (inside <= 0 || !range.holds(near.offset[k])) continue;
        const uint32_t w = static_cast<uint32_t>(inside * inside) >> 12;
        weight[found] = w;
        offset[found] = near.offset[k];
        sum += w;
        ++found;
    }
    count = found;
    while (count > static_cast<int>(most)) sum -= drop_lightest();
    const CoarseReciprocal r = coarse_reciprocal(sum != 0 ? sum : 1);
    uint32_t rest = 1u << bits;
    for (int k = count - 1; k > 0; --k) {
        weight[k] = (weight[k] * static_cast<uint32_t>(r.mantissa)) >> (r.exponent - bits);
        rest -= weight[k];
    }
    if (count > 0) weight[0] = rest;
}

uint32_t KernelTaps::drop_lightest()
{
    int lightest = 0;
    for (int k = 1; k < count; ++k) {
        if (weight[k] < weight[lightest]) lightest = k;
    }
    const uint32_t dropped = weight[lightest];
    --count;
    weight[lightest] = weight[count];
    offset[lightest] = offset[count];
    return dropped;
}

}  // namespace lumi
