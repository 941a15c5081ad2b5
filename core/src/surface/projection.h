// SPDX-License-Identifier: MIT
// Vertices of a surface on the grid of samples.
#pragma once

#include "lumi/detail/register_hints.h"
#include "lumi/surface/detail/pieces.h"
#include "math/reciprocal.h"

namespace lumi::detail
{

// The guard band: samples are addressed from -2^15 to 2^15, an image has at most 2^14 of them a side.
inline constexpr int32_t kGuardQ6 = ((1 << 15) - 64) * 64;
// Surfaces nearer to the eye's plane than 1/256 R are cut away.
inline constexpr int32_t kNearPlaneShift = 8;

// A point on the grid of samples; depth 0: nearer than the near plane or beside the guard band.
struct SamplePoint {
    int32_t x_q6, y_q6;
    uint32_t depth;
};

LUMI_ALWAYS_INLINE int32_t axis_sum(const SurfaceProjection& p, int k, const VertexQ14& v)
{
    return (p.axis[k][0] * v.x + p.axis[k][1] * v.y + p.axis[k][2] * v.z) >> p.shift[k];
}

LUMI_ALWAYS_INLINE ViewPoint view_point(const SurfaceProjection& p, const VertexQ14& v)
{
    return {axis_sum(p, 0, v) + p.eye[0], axis_sum(p, 1, v) + p.eye[1], axis_sum(p, 2, v) + p.eye[2]};
}

LUMI_ALWAYS_INLINE SamplePoint projected(const SurfaceProjection& p, const ViewPoint& v)
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
    const uint32_t ahead = v.z < p.far_z ? static_cast<uint32_t>(p.far_z - v.z) >> p.ahead_shift : 0;
    const uint32_t ratio = (ahead * r.mantissa) >> 16;
    return {x_q6, y_q6, kFarDepth + ((ratio * p.depth_factor) >> (p.depth_shift - r.leading))};
}

LUMI_ALWAYS_INLINE SurfaceVertex packed(const SamplePoint& p, uint32_t colour)
{
    return {static_cast<int32_t>(static_cast<uint32_t>(p.x_q6) << 8 | (p.depth & 0xFF)),
            static_cast<int32_t>(static_cast<uint32_t>(p.y_q6) << 8 | p.depth >> 8), colour};
}

LUMI_ALWAYS_INLINE int32_t x_q6(const SurfaceVertex& v)
{
    return v.x >> 8;
}
LUMI_ALWAYS_INLINE int32_t y_q6(const SurfaceVertex& v)
{
    return v.y >> 8;
}
LUMI_ALWAYS_INLINE uint32_t depth_of(const SurfaceVertex& v)
{
    return static_cast<uint32_t>(v.x & 0xFF) | static_cast<uint32_t>(v.y & 0xFF) << 8;
}

LUMI_ALWAYS_INLINE SamplePoint unpacked(const SurfaceVertex& v)
{
    return {x_q6(v), y_q6(v), depth_of(v)};
}

// A vertex's depth is 0 or at least kFarDepth, so its upper byte alone tells.
LUMI_ALWAYS_INLINE bool is_there(const SurfaceVertex& v)
{
    return (v.y & 0xFF) != 0;
}

// Triangles up to this wide and high take 32-bit products, and the roundings of their colours do not add up to much:
// 128 samples.
inline constexpr int32_t kSmallQ6 = 1 << 13;

// The first line of samples, at y = line + 1/2, at or below a height.
LUMI_ALWAYS_INLINE int32_t line_from(int32_t y_q6)
{
    return (y_q6 + 31) >> 6;
}

LUMI_ALWAYS_INLINE int32_t line_from_packed(int32_t y)
{
    return (y + (31 << 8)) >> 14;
}

// Whether depths differ so much along an edge that texture, affine in the image, would lie more than a pixel off.
bool is_curved(const SurfaceFrame& frame, const SamplePoint& a, const SamplePoint& b);

// Sets `projection` of `out`, whose field and samples are set; false if the sphere lies behind the near plane.
bool set_projection(const SurfaceCamera& camera, SurfaceFrame& out);

}  // namespace lumi::detail
