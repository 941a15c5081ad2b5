// SPDX-License-Identifier: MIT
// One lattice (origins or directions) lies under a scanline's pixels: a line through its cells, or over a pole.
#pragma once

#include "lumi/fixed.h"

namespace lumi::detail
{

// A scanline's way over a pole: a straight line through the constant triangles of the polar pattern
// (src/lattice/polar.h). In Lambert's plane a scanline is nearly a line, so the barycentric weights of a triangle
// advance by additions; where one turns negative the line has crossed that edge and the triangle beyond takes over.
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

    // Returns a corner as a point of the lattice.
    int32_t index(int k) const { return base + corner[k] * step; }
};

struct Zone;

// How a line changes from one scanline to the next.
struct LineChange {
    int32_t u_q16, v_q16, du_q16, dv_q16;
};

// Coordinates of the first pixel and their steps, Q16, in a basis whose steps form an obtuse angle, so that the
// triangle of a cell is decided by fu > fv.
struct CellLine {
    int32_t u_q16, v_q16, du_q16, dv_q16;
    int32_t first, second;  // index steps of u and v, negative where mirrored or reflected
    int32_t base;           // index of (0, 0)
    // The cells whose diagonal is not the sum of both steps: those whose lowest corner, first·a + second·b, is below
    // `flip` where flip_mask is 0, and at `flip` or above where it is -1. Decided cell by cell, as the exact renderer
    // does.
    int32_t flip, flip_mask;
    const Zone* zone;  // that of the steps, for models that count zones
    bool uniform;      // no flipped cell lies under the line

    bool is_flipped(int32_t corner) const { return ((corner - flip) ^ flip_mask) < 0; }
    // The highest index that the corners under `length` pixels can have.
    int32_t highest(int32_t length) const
    {
        const auto index = [&](int32_t u, int32_t v) { return base + first * (u >> 16) + second * (v >> 16); };
        const int32_t a = index(u_q16, v_q16);
        const int32_t b = index(u_q16 + length * du_q16, v_q16 + length * dv_q16);
        // A floor takes up to one step off either coordinate, and a cell's corners lie up to both steps on.
        return (a > b ? a : b) + 2 * (magnitude(first) + magnitude(second));
    }
    void move_down(const LineChange& down, int32_t scanlines)
    {
        u_q16 += scanlines * down.u_q16;
        v_q16 += scanlines * down.v_q16;
        du_q16 += scanlines * down.du_q16;
        dv_q16 += scanlines * down.dv_q16;
    }
};

struct LatticeLine {
    CellLine cells;
    PolarLine polar;
    bool over_pole;  // tells which of the two is used
};

}  // namespace lumi::detail
