// SPDX-License-Identifier: MIT
#include "proxy_points.h"

namespace lumi::proxy_math
{
namespace
{

LUMI_ALWAYS_INLINE ViewPoint view_of(const ProxyProjection& p, const Triple12& v)
{
    const int32_t sum = axis_sum(p, 2, v);
    return {(axis_sum(p, 0, v) >> p.shift[0]) + p.eye[0], (axis_sum(p, 1, v) >> p.shift[1]) + p.eye[1],
            (sum >> p.shift[2]) + p.eye[2], sum};
}

LUMI_ALWAYS_INLINE SamplePoint projected(const ProxyProjection& p, const ViewPoint& v)
{
    if (v.z < p.near_z) return {0, 0, 0};
    const Reciprocal r = reciprocal(static_cast<uint32_t>(v.z));
    // A place grows as its vertex comes near: one that needs a shift to the left is out of the guard band or unknown
    // to less than 1/64 sample.
    const int32_t shift = p.place_shift - r.leading;
    if (shift < 1) return {0, 0, 0};
    const int32_t half = int32_t{1} << (shift - 1);
    const int32_t x_q6 = ((times_q16(v.x, r.mantissa) + half) >> shift) + p.centre_x_q6;
    const int32_t y_q6 = ((times_q16(v.y, r.mantissa) + half) >> shift) + p.centre_y_q6;
    if (x_q6 < -kGuardQ6 || x_q6 > kGuardQ6 || y_q6 < -kGuardQ6 || y_q6 > kGuardQ6) return {0, 0, 0};
    const uint32_t ahead = static_cast<uint32_t>(p.far_sum - v.sum) >> p.ahead_shift;
    const uint32_t ratio = (ahead * r.mantissa) >> 16;
    const uint32_t depth = (ratio * p.depth_factor) >> (p.depth_shift - r.leading);
    return {x_q6, y_q6, static_cast<int32_t>(kFarDepth + depth)};
}

}  // namespace

ViewPoint view_point(const ProxyProjection& p, const Triple12& v)
{
    return view_of(p, v);
}

SamplePoint project(const ProxyProjection& p, const ViewPoint& v)
{
    return projected(p, v);
}

SamplePoint project_vertex(const ProxyProjection& p, const Triple12& v)
{
    return projected(p, view_of(p, v));
}

}  // namespace lumi::proxy_math
