// SPDX-License-Identifier: MIT
// Stepping over a pole's cap: a straight line through the constant triangles of the polar pattern (core/src/polar.h).
//
// In Lambert's plane a span is a line, so the barycentric weights of a triangle advance by additions; where one turns
// negative the line has crossed that edge and the triangle beyond takes over.
#pragma once

#include <cstdint>

namespace lumi
{

struct SpanCap {
    // Position in the plane and its step, Q12 (a point covers an area of π); set by SpanWalker.
    int32_t x_q12, y_q12;
    int32_t dx_q16, dy_q16;
    static constexpr int32_t kAnywhere = -1;
    int32_t triangle;  // a triangle to begin the search at, or kAnywhere

    // The triangle under pixel `at` of the span: corners as indices from the pole, weights and their steps in Q16.
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
};

}  // namespace lumi
