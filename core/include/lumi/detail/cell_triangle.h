// SPDX-License-Identifier: MIT
// Which triangle of a lattice cell a point lies in: the one definition. Loops that draw both sides at once choose the
// same triangles by the halves of words (chord/detail/both_sides_steps.h) or by branches (src/chord/armv6m); tests
// compare them.
#pragma once

#include <stdint.h>

namespace lumi::detail
{

// The triangle of a cell around fractions fu, fv in [0, one): which of its corners are taken, and their weights.
// Cells are cut along the sum of both steps, or flipped: along their difference.
struct CellTriangle {
    int32_t first[3], second[3];  // how often a corner lies a first and a second step on
    int32_t weight[3];

    static CellTriangle of(int32_t fu, int32_t fv, int32_t one, bool flipped)
    {
        if (flipped && fu + fv >= one) return {{1, 1, 0}, {1, 0, 1}, {fu + fv - one, one - fv, one - fu}};
        if (flipped) return {{0, 1, 0}, {0, 0, 1}, {one - fu - fv, fu, fv}};
        if (fu > fv) return {{0, 1, 1}, {0, 0, 1}, {one - fu, fu - fv, fv}};
        return {{0, 0, 1}, {0, 1, 1}, {one - fv, fv - fu, fu}};
    }
};

}  // namespace lumi::detail
