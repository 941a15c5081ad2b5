// SPDX-License-Identifier: MIT
// Vertices of a proxy mesh on the grid of samples.
#pragma once

#include "lumi/detail/register_hints.h"
#include "lumi/proxy/proxy_frame.h"
#include "math/reciprocal.h"

namespace lumi::proxy_math
{

// The guard band: samples are addressed from -2^15 to 2^15, an image has at most 2^14 of them a side.
static_assert(kFarDepth >= 256, "corners look at the upper byte of a depth");
inline constexpr int32_t kGuardQ6 = ((1 << 15) - 64) * 64;

// A point on the sample grid; depth 0: not there, see ProxyVertex.
struct SamplePoint {
    int32_t x_q6, y_q6;
    int32_t depth;
};

// A vertex before the division by its depth.
struct ViewPoint {
    int32_t x, y, z;  // formats of ProxyProjection
    int32_t sum;      // z before shift and eye
};

LUMI_ALWAYS_INLINE int32_t axis_sum(const ProxyProjection& p, int k, const Triple12& v)
{
    const uint32_t sum = static_cast<uint32_t>(p.axis[k][0]) * v.a + static_cast<uint32_t>(p.axis[k][1]) * v.b +
                         static_cast<uint32_t>(p.axis[k][2]) * v.c - static_cast<uint32_t>(p.base[k]);
    return static_cast<int32_t>(sum);
}

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

// Both in one.
LUMI_ALWAYS_INLINE SamplePoint projected(const ProxyProjection& p, const Triple12& v)
{
    return projected(p, view_of(p, v));
}

// The same, where they are rare.
ViewPoint view_point(const ProxyProjection& p, const Triple12& v);
SamplePoint project(const ProxyProjection& p, const ViewPoint& v);
SamplePoint project_vertex(const ProxyProjection& p, const Triple12& v);

LUMI_ALWAYS_INLINE ProxyVertex packed(const SamplePoint& p)
{
    return {static_cast<int32_t>(static_cast<uint32_t>(p.x_q6) << 8) | (p.depth & 0xFF),
            static_cast<int32_t>(static_cast<uint32_t>(p.y_q6) << 8) | (p.depth >> 8)};
}

LUMI_ALWAYS_INLINE SamplePoint unpacked(const ProxyVertex& v)
{
    return {v.x >> 8, v.y >> 8, (v.x & 0xFF) | (v.y & 0xFF) << 8};
}

// A triangle's vertices: the frame's, or three in `room`.
struct Corners {
    const ProxyVertex *a, *b, *c;

    // A depth is 0 or at least kFarDepth, so its upper byte alone tells.
    LUMI_ALWAYS_INLINE bool are_all_there() const
    {
        return (a->y & 0xFF) != 0 && (b->y & 0xFF) != 0 && (c->y & 0xFF) != 0;
    }
};

LUMI_ALWAYS_INLINE Corners corners_of(const ProxyFrame& frame, const Triple12& triangle, ProxyVertex (&room)[3])
{
    const ProxyVertex* vertices = frame.memory.vertices;
    if (vertices != nullptr) return {vertices + triangle.a, vertices + triangle.b, vertices + triangle.c};
    const uint32_t numbers[] = {triangle.a, triangle.b, triangle.c};
    for (int k = 0; k < 3; ++k) {
        room[k] = packed(project_vertex(frame.projection, triple12(frame.mesh.vertices, numbers[k])));
    }
    return {room, room + 1, room + 2};
}

// Triangles up to 256 samples wide and high take 32-bit products.
inline constexpr int32_t kSmallQ6 = 1 << 14;

LUMI_ALWAYS_INLINE int32_t least_of(int32_t a, int32_t b, int32_t c)
{
    const int32_t ab = a < b ? a : b;
    return ab < c ? ab : c;
}
LUMI_ALWAYS_INLINE int32_t most_of(int32_t a, int32_t b, int32_t c)
{
    const int32_t ab = a > b ? a : b;
    return ab > c ? ab : c;
}

// Rows of samples, at y = row + 1/2, that lie between two heights: the first at or below the upper one.
LUMI_ALWAYS_INLINE int32_t row_from(int32_t y_q6)
{
    return (y_q6 + 31) >> 6;
}

// Twice the area, Q12, modulo 2^32; positive where the corners run clockwise on the screen. Right for triangles up to
// 46340/64 samples wide and high.
LUMI_ALWAYS_INLINE int32_t doubled_area(const SamplePoint& a, const SamplePoint& b, const SamplePoint& c)
{
    return static_cast<int32_t>(static_cast<uint32_t>(b.x_q6 - a.x_q6) * static_cast<uint32_t>(c.y_q6 - a.y_q6) -
                                static_cast<uint32_t>(c.x_q6 - a.x_q6) * static_cast<uint32_t>(b.y_q6 - a.y_q6));
}
LUMI_ALWAYS_INLINE int64_t wide_doubled_area(const SamplePoint& a, const SamplePoint& b, const SamplePoint& c)
{
    return wide_product(b.x_q6 - a.x_q6, c.y_q6 - a.y_q6) - wide_product(c.x_q6 - a.x_q6, b.y_q6 - a.y_q6);
}

}  // namespace lumi::proxy_math
