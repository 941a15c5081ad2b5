// SPDX-License-Identifier: MIT
// Charts of guided fields: the tangent frame of an origin point, the one definition that baker and renderer share, and
// where a surface point lies in an origin's chart.
#pragma once

#include "lumi/always_inline.h"
#include "lumi/fixed.h"
#include "lumi/surface_point.h"

namespace lumi
{

// Unit vectors across an origin point, Q14; orthonormal to 2^-12. The numbers themselves define the chart.
struct ChartFrame {
    int16_t tangent_q14[3], bitangent_q14[3];
};

// The frame of the unit vector p, after Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017,
// listing 3. One 32-bit division.
ChartFrame chart_frame(const Vec3q30& p);

// An origin as its chart needs it: its place and the grid points that a unit direction along each axis makes,
// (T + B/√3)·G/2 and (2/√3)·B·G/2, |step| <= 231 grid points.
struct ChartAxes {
    int32_t p_q14[3];
    struct Step {
        int32_t u_q8, v_q8;
    } step[3];
};
ChartAxes chart_axes(const Vec3q30& p, const ChartFrame& frame, uint32_t chart_size);

// Grid coordinates relative to the chart's centre, and |X - p|². Within 1/24 grid point of the real numbers at the
// largest chart for |X - p| >= 1/4; closer to the origin X's own rounding counts, 2^-15/|X - p| of the chart's radius.
struct ChartPlace {
    int32_t u_q8, v_q8;
    uint32_t distance2_q28;
};

// 1/sqrt(v) for v in [1/4, 1): at (64 + k)/256, Q15; in between, the line is within 2^-15 of it.
struct ReciprocalRoots {
    static constexpr uint32_t kSteps = 192;
    uint16_t at_q15[kSteps + 1];
};
extern const ReciprocalRoots kReciprocalRoots;

namespace chart_detail
{

// How often v > 0 can be multiplied by 4. Armv6-M does not count zeros; distances near 1 take two steps.
#if defined(__ARM_ARCH_6M__)
LUMI_ALWAYS_INLINE int quarters(uint32_t v)
{
    int count = 0;
    for (; v < uint32_t{1} << 30; v <<= 2) ++count;
    return count;
}
#else
LUMI_ALWAYS_INLINE int quarters(uint32_t v)
{
    return __builtin_clz(v) >> 1;
}
#endif

// Modulo 2^32: in range for every X inside the unit sphere; whatever a file may hold, only the place is wrong.
LUMI_ALWAYS_INLINE uint32_t product(int32_t a, int32_t b)
{
    return static_cast<uint32_t>(a) * static_cast<uint32_t>(b);
}

}  // namespace chart_detail

// Where X lies in a chart. About 40 instructions: nine products, no division.
LUMI_ALWAYS_INLINE ChartPlace chart_place(const ChartAxes& axes, const SurfacePoint& x)
{
    using chart_detail::product;
    const int32_t e[3] = {x.x_q14 - axes.p_q14[0], x.y_q14 - axes.p_q14[1], x.z_q14 - axes.p_q14[2]};
    const uint32_t distance2_q28 = product(e[0], e[0]) + product(e[1], e[1]) + product(e[2], e[2]);

    // distance² = mantissa·4^-scale with the mantissa in [1/4, 1), Q32.
    const int scale = chart_detail::quarters(distance2_q28 | 1);
    const uint32_t mantissa_q32 = (distance2_q28 | 1) << (2 * scale);
    const uint16_t* entry = &kReciprocalRoots.at_q15[(mantissa_q32 >> 24) - 64];
    const uint32_t drop = ((static_cast<uint32_t>(entry[0]) - entry[1]) * ((mantissa_q32 >> 8) & 0xFFFFu)) >> 16;
    const uint32_t inverse_q15 = entry[0] - drop;

    // A product with e is Q22 and at most 231·|e|; at Q8, times the inverse mantissa's root, it stays below 2^31.
    const ChartAxes::Step(&step)[3] = axes.step;
    const uint32_t u = product(step[0].u_q8, e[0]) + product(step[1].u_q8, e[1]) + product(step[2].u_q8, e[2]);
    const uint32_t v = product(step[0].v_q8, e[0]) + product(step[1].v_q8, e[1]) + product(step[2].v_q8, e[2]);
    const auto coordinate = [&](uint32_t along) {
        const int32_t along_q8 = static_cast<int32_t>(along) >> (16 - scale);
        return static_cast<int32_t>(static_cast<uint32_t>(along_q8) * inverse_q15) >> 15;
    };
    return {coordinate(u), coordinate(v), distance2_q28};
}

}  // namespace lumi
