// SPDX-License-Identifier: MIT
// The triangle of the polar pattern around a direction.
#pragma once

#include "lattice/lattice_query.h"

namespace lumi::detail
{

// Corners are points of the pattern (lattice/polar.h), for both poles alike; weights sum to kWeightOneQ12.
struct PolarTriangle {
    const uint8_t* corners;
    uint32_t weight_q12[3];
};

// Finds the triangle of a direction whose real-valued index is below polar::kReach; `query` is make_query() of it. The
// place in the plane comes from x and y: a height does not resolve what lies around a pole.
PolarTriangle polar_triangle(const Lattice& lattice, const Query& query, const Vec3q30& direction);

// The query, moved from where longitude and height see it towards where the weights put it: all the way at
// polar::kBlendBegin, not at all at polar::kBlendEnd. Both are maps of one triangulation, and so is what lies between.
Query blended(const Query& query, const PolarTriangle& weights);

}  // namespace lumi::detail
