// SPDX-License-Identifier: MIT
// Charts of guided fields: the tangent frame of an origin point, the one definition that baker and renderer share, and
// where a surface point lies in an origin's chart.
#pragma once

#include "lumi/detail/halves.h"
#include "lumi/detail/register_hints.h"
#include "lumi/fixed.h"
#include "lumi/guided/guided_sums.h"

namespace lumi
{

// Unit vectors across an origin point, Q14; orthonormal to 2^-12. The numbers themselves define the chart.
struct ChartFrame {
    int16_t tangent_q14[3], bitangent_q14[3];
};

// The frame of the unit vector p, after Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017,
// listing 3. One 32-bit division.
ChartFrame chart_frame(const Vec3q30& p);

// An origin to the bits that its axes need.
struct ChartPoint {
    int16_t q14[3];
};
ChartAxes chart_axes(const ChartPoint& p, const ChartFrame& frame, uint32_t chart_size);
ChartAxes chart_axes(const Vec3q30& p, const ChartFrame& frame, uint32_t chart_size);

// Grid coordinates, and |X - p|². Within 1/24 grid point of the real numbers at the
// largest chart for |X - p| >= 1/4; closer to the origin X's own rounding counts, 2^-15/|X - p| of the chart's radius.
struct ChartPlace {
    int32_t u_q8, v_q8;
    uint32_t distance2_q28;
};

// 1/sqrt(v) for v in [1/4, 1): at (64 + k)/256, Q15, in the upper half, and how much less it is at the next in the
// lower; in between, the line is within 2^-15 of it.
struct ReciprocalRoots {
    static constexpr uint32_t kSteps = 192;
    uint32_t at_q15[kSteps];

    // The entry of v = step/256, step >= 64: the table's address less 64 entries is a constant, too.
    LUMI_ALWAYS_INLINE uint32_t from(uint32_t step) const
    {
        const uintptr_t first = reinterpret_cast<uintptr_t>(at_q15) - 64 * sizeof at_q15[0];
        return *reinterpret_cast<const uint32_t*>(first + sizeof at_q15[0] * step);
    }
};
extern const ReciprocalRoots kReciprocalRoots;

namespace chart_detail
{

// distance² = mantissa·4^-scale with the mantissa in [1/4, 1), Q32.
struct Scaled {
    uint32_t mantissa_q32;
    int scale;
};

// Of v > 0. Armv6-M does not count zeros; distances of 1/8 to 1 take one step or two, besides the first.
#if defined(__ARM_ARCH_6M__)
LUMI_ALWAYS_INLINE Scaled scaled(uint32_t v)
{
    int scale = 0;
    if (v >> 26 == 0) {
        v <<= 4;
        scale = 2;
    }
    for (; v >> 30 == 0; v <<= 2) ++scale;
    return {v, scale};
}
#else
LUMI_ALWAYS_INLINE Scaled scaled(uint32_t v)
{
    const int scale = __builtin_clz(v) >> 1;
    return {v << (2 * scale), scale};
}
#endif

}  // namespace chart_detail

// Where X lies in a chart whose centre is `centre_q8`. About 40 instructions: nine products, no division. Modulo 2^32:
// in range for every X inside the unit sphere; whatever a file may hold, only the place is wrong. The centre is a
// reference so that it is read after the sums, which need the registers.
LUMI_ALWAYS_INLINE ChartPlace chart_place(const ChartAxes& axes, const SquaredPoint& x, const int32_t& centre_q8)
{
    const PointSums sums = point_sums(axes, x);
    const chart_detail::Scaled distance = chart_detail::scaled(sums.distance2_q28 | 1);
    const uint32_t entry = kReciprocalRoots.from(distance.mantissa_q32 >> 24);
    const uint32_t drop = part_by_low((distance.mantissa_q32 >> 8) & 0xFFFFu, entry);
    const uint32_t inverse_q15 = (entry >> 16) - drop;

    // A product with X - p is Q22 and at most 231·|X - p|; at Q8, times the inverse mantissa's root, below 2^31.
    const auto coordinate = [&](uint32_t along_q22) {
        const int32_t along_q8 = static_cast<int32_t>(along_q22) >> (16 - distance.scale);
        return centre_q8 + (static_cast<int32_t>(static_cast<uint32_t>(along_q8) * inverse_q15) >> 15);
    };
    return {coordinate(sums.u_q22), coordinate(sums.v_q22), sums.distance2_q28};
}

}  // namespace lumi
