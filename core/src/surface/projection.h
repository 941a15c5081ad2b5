// SPDX-License-Identifier: MIT
// Vertices of a surface on the grid of samples, triangles as their vertices lie, and their light.
#pragma once

#include "lumi/detail/compiler.h"
#include "lumi/surface/detail/pieces.h"
#include "math/reciprocal.h"

namespace lumi::detail
{

// The guard band: samples are addressed from -2^15 to 2^15, an image has at most 2^14 of them a side.
inline constexpr int32_t kGuardQ6 = ((1 << 15) - 64) * 64;
// Surfaces nearer to the eye's plane than 1/256 R are cut away.
inline constexpr int32_t kNearPlaneShift = 8;

// This is a point on the grid of samples; depth 0: nearer than the near plane or beside the guard band.
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

// Returns the first line of samples, at y = line + 1/2, at or below a height: ceil(y - 1/2), in 1/64.
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

inline constexpr uint32_t kUnlit = 1;  // a vertex's colour before it is known: in the two bits that no colour uses

// Returns the light of a vertex's view table for the frame's eye.
uint32_t lit_colour(const SurfaceFrame& frame, uint32_t vertex);

LUMI_ALWAYS_INLINE void light(const SurfaceFrame& frame, const SurfaceVertex* v)
{
    if (v->colour != kUnlit) return;
    const uint32_t vertex = static_cast<uint32_t>(v - frame.memory.vertices);
    frame.memory.vertices[vertex].colour = lit_colour(frame, vertex);
}

// Corners of a triangle. Packed numbers compare as their upper bits do.
struct Seen {
    const SurfaceVertex *a, *b, *c;

    bool are_there() const { return is_there(*a) && is_there(*b) && is_there(*c); }
    int32_t upper() const { return least_of(a->y, b->y, c->y); }
    int32_t lower() const { return most_of(a->y, b->y, c->y); }
    int32_t left() const { return least_of(a->x, b->x, c->x); }
    int32_t right() const { return most_of(a->x, b->x, c->x); }
};

// Twice an area's sign, as that of doubled_area (planes.h), where 32 bits do not hold it.
__attribute__((noinline)) inline int32_t wide_sign(int32_t ax, int32_t by, int32_t bx, int32_t ay)
{
    const int64_t area = wide_product(ax, by) - wide_product(bx, ay);
    return area < 0 ? -1 : area > 0 ? 1 : 0;
}

// Whether a triangle can be drawn as a whole.
inline bool is_small(const SurfaceFrame& frame, const Seen& s)
{
    constexpr int32_t kSmall = (kSmallQ6 - 1) << 8;
    if (s.lower() - s.upper() >= kSmall || s.right() - s.left() >= kSmall) return false;
    const SamplePoint a = unpacked(*s.a), b = unpacked(*s.b), c = unpacked(*s.c);
    return !is_curved(frame, a, b) && !is_curved(frame, b, c) && !is_curved(frame, c, a);
}

}  // namespace lumi::detail
