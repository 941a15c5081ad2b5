// SPDX-License-Identifier: MIT
// A triangle of a frame as its vertices lie, and their light.
#pragma once

#include "surface/extremes.h"
#include "surface/projection.h"

namespace lumi::detail
{

inline constexpr uint32_t kUnlit = 1;  // a vertex's colour before it is known: in the two bits that no colour uses

// What a vertex's view table shows of the eye.
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
