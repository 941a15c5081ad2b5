// SPDX-License-Identifier: MIT
// Triangles of small lattices, where the pattern of one pole reaches into the other's.
#pragma once

#include "lumi/detail/lattice.h"

namespace lumi::detail
{

// The triangle of the points' convex hull that a direction points at, weighted by where it meets it. Below 4 points,
// whose hull does not surround the centre: the two points next in height. Looks at the nearest 9 points, of which the
// hull's triangle are three for every size below 64 (tests/core/lattice/triangle_test.cpp).
Triangle hull_triangle(const Lattice& lattice, const Vec3q30& direction);

}  // namespace lumi::detail
