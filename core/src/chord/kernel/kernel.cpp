// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/kernel/kernel.h"

#include "lattice/polar.h"

namespace lumi::detail
{
namespace
{

constexpr int32_t kOneQ12 = 4096;
constexpr int32_t kInversePiQ15 = 10430;

constexpr SumReciprocals make_sum_reciprocals()
{
    SumReciprocals t{};
    for (int32_t k = 0; k < SumReciprocals::kCount; ++k) {
        const uint32_t middle_q9 = static_cast<uint32_t>(256 + 2 * k + 1);
        t.q11[k] = static_cast<uint16_t>(((1u << 20) + (1u << 12)) / middle_q9);
    }
    t.q11[SumReciprocals::kCount - 1] = 1 << 9;
    return t;
}

}  // namespace

const SumReciprocals kSumReciprocals = make_sum_reciprocals();

// Distances in Lambert's plane, where a point covers an area of π and the mean spacing is √π.
PolarPoints::PolarPoints(const PolarLine& line, int32_t pixel)
{
    const int32_t x = line.x_q12 + ((pixel * line.dx_q16) >> 4);
    const int32_t y = line.y_q12 + ((pixel * line.dy_q16) >> 4);
    const uint8_t* beyond = polar::beyond(line.triangle);
    const uint8_t* own = polar::corners(line.triangle);
#pragma GCC unroll 6
    for (int k = 0; k < kCount; ++k) {  // unrolled: nothing is divided by 3
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
        index[k] = line.base + corner * line.step;
        distance2_q12[k] = doubled ? kOneQ12 : (((dx * dx + dy * dy) >> 8) * kInversePiQ15) >> 15;
    }
}

void KernelTaps::set(const PolarPoints& near, int most, int bits)
{
    uint32_t sum = 0;
    count = 0;
#pragma GCC unroll 6
    for (int k = 0; k < PolarPoints::kCount; ++k) {
        const int32_t inside = kOneQ12 - near.distance2_q12[k];
        if (inside <= 0) continue;
        const uint32_t w = static_cast<uint32_t>(inside * inside) >> 12;
        int at = count;
        if (count == most) {
            at = 0;
            for (int j = 1; j < most; ++j)
                if (weight[j] < weight[at]) at = j;
            if (weight[at] >= w) continue;
            sum -= weight[at];
        } else {
            ++count;
        }
        weight[at] = w;
        offset[at] = near.index[k];
        sum += w;
    }
    const CoarseReciprocal r = coarse_reciprocal(sum != 0 ? sum : 1);
    uint32_t rest = 1u << bits;
    for (int k = count - 1; k > 0; --k) {
        weight[k] = (weight[k] * static_cast<uint32_t>(r.mantissa)) >> (r.exponent - bits);
        rest -= weight[k];
    }
    if (count > 0) weight[0] = rest;
}

}  // namespace lumi::detail
