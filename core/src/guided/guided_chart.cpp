// SPDX-License-Identifier: MIT
#include "lumi/guided/guided_chart.h"

#include "math/generate.h"

namespace lumi
{
namespace
{

constexpr ReciprocalRoots make_reciprocal_roots()
{
    ReciprocalRoots t{};
    uint32_t last = 0;
    for (uint32_t k = 0; k <= ReciprocalRoots::kSteps; ++k) {
        const double v = 32768 / generate::root((64.0 + k) / 256) + 0.5;
        const uint32_t rounded = v > 65535 ? 65535 : static_cast<uint32_t>(v);
        if (k > 0) t.at_q15[k - 1] = last << 16 | (last - rounded);
        last = rounded;
    }
    return t;
}

}  // namespace

constexpr ReciprocalRoots kReciprocalRoots = make_reciprocal_roots();

ChartFrame chart_frame(const Vec3q30& p)
{
    const int32_t x_q15 = p.x >> 15, y_q15 = p.y >> 15, z_q15 = p.z >> 15;
    const int32_t sign = z_q15 < 0 ? -1 : 1;
    const int32_t scale_q15 = (int32_t{1} << 30) / ((int32_t{1} << 15) + sign * z_q15);  // 1/(1+|z|), 1/2 to 1
    const int32_t xs_q15 = (x_q15 * scale_q15) >> 15, ys_q15 = (y_q15 * scale_q15) >> 15;
    const auto q14 = [](int32_t value_q15) { return static_cast<int16_t>(value_q15 >> 1); };
    const int32_t one_q15 = int32_t{1} << 15;
    const int32_t xx_q15 = (xs_q15 * x_q15) >> 15, xy_q15 = (xs_q15 * y_q15) >> 15, yy_q15 = (ys_q15 * y_q15) >> 15;
    return {{q14(one_q15 - xx_q15), q14(-xy_q15), q14(-sign * x_q15)},
            {q14(-sign * xy_q15), q14(sign * (one_q15 - yy_q15)), q14(-y_q15)}};
}

ChartAxes chart_axes(const Vec3q30& p, const ChartFrame& frame, uint32_t chart_size)
{
    const auto q14 = [](int32_t v_q30) { return static_cast<int16_t>((v_q30 + (1 << 15)) >> 16); };
    return chart_axes(ChartPoint{{q14(p.x), q14(p.y), q14(p.z)}}, frame, chart_size);
}

ChartAxes chart_axes(const ChartPoint& p, const ChartFrame& frame, uint32_t chart_size)
{
    constexpr int32_t kInverseRoot3Q16 = 37837;     // 1/√3
    constexpr int32_t kTwoInverseRoot3Q16 = 75674;  // 2/√3
    const int32_t size = static_cast<int32_t>(chart_size);
    // A unit vector's component, at most 2/√3 long after the shear: Q30 below 2^31, Q16 times G <= 400 below 2^26.
    const auto grid_q8 = [&](int32_t axis_q30) { return ((axis_q30 >> 14) * size + 256) >> 9; };
    ChartAxes axes;
    uint32_t* const to_distance[] = {&axes.distance2_q28.x, &axes.distance2_q28.y, &axes.distance2_q28.z};
    uint32_t* const to_u[] = {&axes.u_q22.x, &axes.u_q22.y, &axes.u_q22.z};
    uint32_t* const to_v[] = {&axes.v_q22.x, &axes.v_q22.y, &axes.v_q22.z};
    uint32_t square = 0, u = 0, v = 0;  // products with p
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
        const int32_t tangent_q30 = frame.tangent_q14[k] * (int32_t{1} << 16);
        const uint32_t p_q14 = static_cast<uint32_t>(p.q14[k]);
        *to_distance[k] = 0u - 2 * p_q14;
        *to_u[k] = static_cast<uint32_t>(grid_q8(tangent_q30 + frame.bitangent_q14[k] * kInverseRoot3Q16));
        *to_v[k] = static_cast<uint32_t>(grid_q8(frame.bitangent_q14[k] * kTwoInverseRoot3Q16));
        square += p_q14 * p_q14;
        u += *to_u[k] * p_q14;
        v += *to_v[k] * p_q14;
    }
    axes.distance2_q28.constant = square;
    axes.u_q22.constant = 0u - u;
    axes.v_q22.constant = 0u - v;
    return axes;
}

}  // namespace lumi
