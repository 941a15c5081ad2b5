// SPDX-License-Identifier: MIT
// A scanline's way over a pole: a straight line through the constant triangles of the polar pattern
// (src/lattice/polar.h).
//
// In Lambert's plane a scanline is nearly a line, so the barycentric weights of a triangle advance by additions; where
// one turns negative the line has crossed that edge and the triangle beyond takes over.
#pragma once

#include <stdint.h>

namespace lumi::detail
{

struct PolarLine {
    // The first pixel's place in the plane (a point covers an area of π) and the way to the next one.
    int32_t x_q12, y_q12;
    int32_t dx_q16, dy_q16;
    int32_t base, step;  // the pattern's point k is the lattice's point base + k·step
    int32_t triangle;    // where the search for a pixel's triangle begins

    // The triangle under a pixel: corners as points of the pattern, weights and their steps in Q16.
    int32_t corner[3];
    int32_t weight_q16[3];
    int32_t step_q16[3];

    // Finds the triangle under pixel `at`, walking from `triangle`. Weights are clamped to >= 0 and sum to 65,536.
    void find(int32_t at);

    // Advances to pixel `at`, the next one.
    void advance(int32_t at)
    {
        weight_q16[0] += step_q16[0];
        weight_q16[1] += step_q16[1];
        weight_q16[2] += step_q16[2];
        if ((weight_q16[0] | weight_q16[1] | weight_q16[2]) < 0) find(at);
    }

    // A corner as a point of the lattice.
    int32_t index(int k) const { return base + corner[k] * step; }
};

}  // namespace lumi::detail
