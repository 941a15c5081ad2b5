// SPDX-License-Identifier: MIT
// Which nodes of a view table (surface/format.h) a direction lies between, and with what weights.
//
// Nodes are the first points of a Spherical Fibonacci lattice; their triangles are constants, as those around a pole
// are (lattice/polar.h). A direction (x, y, z) is looked up in the plane
//     s = (x + y)/d        t = (x - y)/d        d = |x| + |y| + z
// in which the upper half of the octahedral map is the square from -1 to 1: one quotient, no root, so directions need
// no unit length. Weights are barycentric in that plane: continuous over all directions.
#pragma once

#include <stdint.h>

#include "lumi/surface/format.h"

namespace lumi::detail
{

struct ViewTaps {
    uint8_t node[3];        // < kViewNodes
    uint16_t weight_q8[3];  // they sum to 256
};

// The taps for a direction in the vertex's frame: components of at most 2^16, not all 0. Below z = -0.2 (about) the
// nearest nodes there are.
ViewTaps view_taps(int32_t x, int32_t y, int32_t z);

struct ViewDirection {
    int32_t x, y, z;
};

// A direction in the vertex's frame: `w`, with components of at most 2^15, after half a turn about h = turn/127.
inline ViewDirection in_view_frame(const ViewDirection& w, int32_t turn_x, int32_t turn_y, int32_t turn_z)
{
    const int32_t along = (turn_x * w.x + turn_y * w.y + turn_z * w.z) >> 7;
    return {((along * turn_x) >> 6) - w.x, ((along * turn_y) >> 6) - w.y, ((along * turn_z) >> 6) - w.z};
}

}  // namespace lumi::detail
