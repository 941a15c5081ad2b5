// SPDX-License-Identifier: MIT
#include "lumi/guided_chart.h"

#include "generate.h"

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
    constexpr int32_t kInverseRoot3Q16 = 37837;     // 1/√3
    constexpr int32_t kTwoInverseRoot3Q16 = 75674;  // 2/√3
    const int32_t size = static_cast<int32_t>(chart_size);
    // A unit vector's component, at most 2/√3 long after the shear: Q30 below 2^31, Q16 times G <= 400 below 2^26.
    const auto grid_q8 = [&](int32_t axis_q30) { return ((axis_q30 >> 14) * size + 256) >> 9; };
    const int32_t place_q30[3] = {p.x, p.y, p.z};
    uint32_t u_q8[3], v_q8[3], p_q14[3];
    for (int k = 0; k < 3; ++k) {
        const int32_t tangent_q30 = frame.tangent_q14[k] * (int32_t{1} << 16);
        p_q14[k] = static_cast<uint32_t>((place_q30[k] + (1 << 15)) >> 16);
        u_q8[k] = static_cast<uint32_t>(grid_q8(tangent_q30 + frame.bitangent_q14[k] * kInverseRoot3Q16));
        v_q8[k] = static_cast<uint32_t>(grid_q8(frame.bitangent_q14[k] * kTwoInverseRoot3Q16));
    }
    const auto with_p = [&](const uint32_t(&a)[3]) { return a[0] * p_q14[0] + a[1] * p_q14[1] + a[2] * p_q14[2]; };
    const auto from_p = [&](const uint32_t(&a)[3]) -> PointForm { return {a[0], a[1], a[2], 0u - with_p(a)}; };
    return {{0u - 2 * p_q14[0], 0u - 2 * p_q14[1], 0u - 2 * p_q14[2], with_p(p_q14)}, from_p(u_q8), from_p(v_q8)};
}

}  // namespace lumi
