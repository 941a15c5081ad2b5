// SPDX-License-Identifier: MIT
#include "lumi/span_cap.h"

#include "lumi/span_node.h"
#include "polar.h"

namespace lumi
{
namespace
{

// A triangle of the pattern, its parts at a position (twice the area opposite each corner, Q24) and how they change.
struct Parts {
    polar::PlanePoint p[3];
    int32_t area[3];

    Parts(int32_t triangle, int32_t x_q12, int32_t y_q12)
    {
        const uint8_t* c = polar::corners(triangle);
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k) p[k] = polar::plane_point(c[k]);
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k) {
            const polar::PlanePoint a = p[(k + 1) % 3];
            const polar::PlanePoint b = p[(k + 2) % 3];
            area[k] = (b.x_q12 - a.x_q12) * (y_q12 - a.y_q12) - (b.y_q12 - a.y_q12) * (x_q12 - a.x_q12);
        }
    }

    // The edge to cross, opposite the most negative part that has a triangle beyond; -1 where there is none.
    int way_out(const uint8_t* beyond) const
    {
        int edge = -1;
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k) {
            if (area[k] < 0 && beyond[k] != polar::kNone && (edge < 0 || area[k] < area[edge])) edge = k;
        }
        return edge;
    }

    int32_t change(int k, int32_t dx_q16, int32_t dy_q16) const
    {
        const polar::PlanePoint a = p[(k + 1) % 3];
        const polar::PlanePoint b = p[(k + 2) % 3];
        return ((b.x_q12 - a.x_q12) * (dy_q16 >> 2) - (b.y_q12 - a.y_q12) * (dx_q16 >> 2)) >> 2;
    }
};

// Walks towards the triangle that holds (x, y); beyond the table's end it stops at one next to it.
Parts locate(int32_t& triangle, int32_t x_q12, int32_t y_q12)
{
    Parts parts(triangle, x_q12, y_q12);
    for (int step = 0; step < polar::kTriangles; ++step) {
        const int edge = parts.way_out(polar::beyond(triangle));
        if (edge < 0) break;
        triangle = polar::beyond(triangle)[edge];
        parts = Parts(triangle, x_q12, y_q12);
    }
    return parts;
}

}  // namespace

void SpanCap::find(int32_t at)
{
    const int32_t x = x_q12 + ((at * dx_q16) >> 4);
    const int32_t y = y_q12 + ((at * dy_q16) >> 4);
    const Parts parts = locate(triangle, x, y);
    int32_t area[3];
    int32_t sum = 0;
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
        area[k] = parts.area[k] > 0 ? parts.area[k] : 0;
        sum += area[k];
    }
    // The weights of Q24 areas over their sum; sum is about π in Q24, so the reciprocal keeps 15 bits of it.
    const CoarseReciprocal r = coarse_reciprocal(static_cast<uint32_t>(sum));
    const int shift = r.exponent - 16 - 11;
    // A step that crosses whole triangles is cut short: the next pixel finds its own.
    const auto share = [&](int32_t a) {
        constexpr int32_t kLimit = 1 << 26;
        const int32_t kept = a > kLimit ? kLimit : a < -kLimit ? -kLimit : a;
        return ((kept >> 11) * r.mantissa) >> shift;
    };
    const uint8_t* corners = polar::corners(triangle);
    corner[0] = corners[0];
#pragma GCC unroll 2
    for (int k = 1; k < 3; ++k) {
        corner[k] = corners[k];
        weight_q16[k] = share(area[k]);
        step_q16[k] = share(parts.change(k, dx_q16, dy_q16));
    }
    weight_q16[0] = 65536 - weight_q16[1] - weight_q16[2];
    step_q16[0] = -step_q16[1] - step_q16[2];
    if (weight_q16[0] < 0) {
        weight_q16[1] += weight_q16[0];
        weight_q16[0] = 0;
    }
}

}  // namespace lumi
