// SPDX-License-Identifier: MIT
// Cuts polygons into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/vec3.h"

namespace lumi::baker
{

// Indices into `corners`, n-2 triangles at most, wound like the polygon. Concave polygons are cut by their ears; a
// polygon that crosses itself gets triangles, but not the ones its author had in mind. Cost: linear in n if it is
// convex, or has more corners than kMostEars, when it is cut as if it were; else quadratic to cubic.
inline constexpr size_t kMostEars = 4096;
std::vector<std::array<uint32_t, 3>> triangulate(const std::vector<Vec3>& corners);

// Whether a triangle is so thin that binary32 cannot say which way it faces. Relative to its edges, so that neither
// tiny nor huge scenes lose sound triangles.
bool has_no_area(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace lumi::baker
