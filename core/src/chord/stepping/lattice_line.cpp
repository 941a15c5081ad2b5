// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/stepping/lattice_line.h"

#include "lattice/polar.h"

namespace lumi::detail
{
namespace
{

constexpr int32_t kWholeQ16 = 1 << 16;

// Gradients are shorter than 1, places less than 5 from the pole and points less than 7: 2^14 · 2^12 · 12 < 2^31, and
// 2^14 · 2^13 · 10 for steps in Q13.
int32_t change_q16(const polar::Gradient& g, int32_t dx_q12, int32_t dy_q12)
{
    return (g.x_q14 * dx_q12 + g.y_q14 * dy_q12) >> 10;
}

// The edge to cross, opposite the most negative weight that has a triangle beyond; -1 where there is none.
int way_out(const int32_t weight_q16[3], const uint8_t beyond[3])
{
    int edge = -1;
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
        if (weight_q16[k] < 0 && beyond[k] != polar::kNone && (edge < 0 || weight_q16[k] < weight_q16[edge])) edge = k;
    return edge;
}

// Beside the table's last triangles: the nearest point of their edge, near enough.
void clamp(int32_t weight_q16[3])
{
    const auto clamped = [](int32_t v, int32_t most) { return v < 0 ? 0 : v < most ? v : most; };
    weight_q16[1] = clamped(weight_q16[1], kWholeQ16);
    weight_q16[2] = clamped(weight_q16[2], kWholeQ16 - weight_q16[1]);
    weight_q16[0] = kWholeQ16 - weight_q16[1] - weight_q16[2];
}

}  // namespace

void PolarLine::find(int32_t at)
{
    const int32_t x = x_q12 + ((at * dx_q16) >> 4);
    const int32_t y = y_q12 + ((at * dy_q16) >> 4);
    const polar::TriangleWalk* found = &polar::kWalks.triangle[triangle];
    for (int crossed = 0;; ++crossed) {
        const polar::PlanePoint p = polar::plane_point(polar::corners(triangle)[0]);
        weight_q16[1] = change_q16(found->weight[0], x - p.x_q12, y - p.y_q12);
        weight_q16[2] = change_q16(found->weight[1], x - p.x_q12, y - p.y_q12);
        weight_q16[0] = kWholeQ16 - weight_q16[1] - weight_q16[2];
        if ((weight_q16[0] | weight_q16[1] | weight_q16[2]) >= 0) break;
        const int edge = way_out(weight_q16, found->beyond);
        if (edge < 0 || crossed == polar::kWalkTriangles) {
            clamp(weight_q16);
            break;
        }
        triangle = found->beyond[edge];
        found = &polar::kWalks.triangle[triangle];
    }
    const uint8_t* const corners = polar::corners(triangle);
    corner[0] = corners[0];
    corner[1] = corners[1];
    corner[2] = corners[2];
    step_q16[1] = change_q16(found->weight[0], dx_q16 >> 3, dy_q16 >> 3) >> 1;
    step_q16[2] = change_q16(found->weight[1], dx_q16 >> 3, dy_q16 >> 3) >> 1;
    step_q16[0] = -step_q16[1] - step_q16[2];
}

}  // namespace lumi::detail
