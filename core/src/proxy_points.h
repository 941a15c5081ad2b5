// SPDX-License-Identifier: MIT
// Vertices of a proxy mesh on the grid of samples.
#pragma once

#include "lumi/always_inline.h"
#include "lumi/proxy_frame.h"
#include "proxy_reciprocal.h"

namespace lumi::proxy_math
{

// The guard band: samples are addressed from -2^15 to 2^15, an image has at most 2^14 of them a side.
static_assert(kFarDepth >= 256, "corners_of looks at the upper byte of a depth");
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

ViewPoint view_point(const ProxyProjection& p, const Triple12& v);
SamplePoint project(const ProxyProjection& p, const ViewPoint& v);
SamplePoint project_vertex(const ProxyProjection& p, const Triple12& v);  // both in one

LUMI_ALWAYS_INLINE ProxyVertex packed(const SamplePoint& p)
{
    return {static_cast<int32_t>(static_cast<uint32_t>(p.x_q6) << 8) | (p.depth & 0xFF),
            static_cast<int32_t>(static_cast<uint32_t>(p.y_q6) << 8) | (p.depth >> 8)};
}

LUMI_ALWAYS_INLINE SamplePoint unpacked(const ProxyVertex& v)
{
    return {v.x >> 8, v.y >> 8, (v.x & 0xFF) | (v.y & 0xFF) << 8};
}

struct Corners {
    SamplePoint point[3];
    bool are_all_there;
};

LUMI_ALWAYS_INLINE Corners corners_of(const ProxyFrame& frame, const Triple12& triangle)
{
    if (frame.memory.vertices != nullptr) {
        const ProxyVertex& a = frame.memory.vertices[triangle.a];
        const ProxyVertex& b = frame.memory.vertices[triangle.b];
        const ProxyVertex& c = frame.memory.vertices[triangle.c];
        // A depth is 0 or at least kFarDepth, so its upper byte alone tells.
        return {{unpacked(a), unpacked(b), unpacked(c)}, (a.y & 0xFF) != 0 && (b.y & 0xFF) != 0 && (c.y & 0xFF) != 0};
    }
    const auto point = [&](uint32_t vertex) {
        return project_vertex(frame.projection, triple12(frame.mesh.vertices, vertex));
    };
    const SamplePoint a = point(triangle.a), b = point(triangle.b), c = point(triangle.c);
    return {{a, b, c}, a.depth != 0 && b.depth != 0 && c.depth != 0};
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
