// SPDX-License-Identifier: MIT
#include "lumi/span_cap.h"

#include "lumi/span_node.h"
#include "polar.h"

namespace lumi
{
namespace
{

struct Corners {
    polar::PlanePoint p[3];

    explicit Corners(int32_t triangle)
    {
        const uint8_t* c = polar::corners(triangle);
        for (int k = 0; k < 3; ++k) p[k] = polar::plane_point(c[k]);
    }

    // Twice the area of the part opposite corner k, Q24, and how it changes along (dx, dy).
    int32_t area(int k, int32_t x_q12, int32_t y_q12) const
    {
        const polar::PlanePoint a = p[(k + 1) % 3];
        const polar::PlanePoint b = p[(k + 2) % 3];
        return (b.x_q12 - a.x_q12) * (y_q12 - a.y_q12) - (b.y_q12 - a.y_q12) * (x_q12 - a.x_q12);
    }
    int32_t change(int k, int32_t dx_q16, int32_t dy_q16) const
    {
        const polar::PlanePoint a = p[(k + 1) % 3];
        const polar::PlanePoint b = p[(k + 2) % 3];
        return ((b.x_q12 - a.x_q12) * (dy_q16 >> 2) - (b.y_q12 - a.y_q12) * (dx_q16 >> 2)) >> 2;
    }
};

// Walks towards the triangle that holds (x, y); at the table's end it stops at the nearest one.
int32_t locate(int32_t triangle, int32_t x_q12, int32_t y_q12)
{
    for (int step = 0; step < polar::kTriangles; ++step) {
        const Corners corners(triangle);
        int worst = 0;
        int32_t least = corners.area(0, x_q12, y_q12);
        for (int k = 1; k < 3; ++k) {
            const int32_t area = corners.area(k, x_q12, y_q12);
            if (area < least) {
                least = area;
                worst = k;
            }
        }
        const uint8_t next = polar::beyond(triangle)[worst];
        if (least >= 0 || next == polar::kNone) return triangle;
        triangle = next;
    }
    return triangle;
}

}  // namespace

void SpanCap::find(int32_t at)
{
    const int32_t x = x_q12 + ((at * dx_q16) >> 4);
    const int32_t y = y_q12 + ((at * dy_q16) >> 4);
    triangle = locate(triangle, x, y);
    const Corners corners(triangle);
    int32_t area[3];
    int32_t sum = 0;
    for (int k = 0; k < 3; ++k) {
        const int32_t a = corners.area(k, x, y);
        area[k] = a > 0 ? a : 0;
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
    for (int k = 0; k < 3; ++k) {
        corner[k] = polar::corners(triangle)[k];
        weight_q16[k] = share(area[k]);
        step_q16[k] = share(corners.change(k, dx_q16, dy_q16));
    }
    weight_q16[0] = 65536 - weight_q16[1] - weight_q16[2];
    step_q16[0] = -step_q16[1] - step_q16[2];
    if (weight_q16[0] < 0) {
        weight_q16[1] += weight_q16[0];
        weight_q16[0] = 0;
    }
}

}  // namespace lumi
