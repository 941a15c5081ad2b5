// SPDX-License-Identifier: MIT
// Coordinates as files have them, in double precision: maps and scans lie millions of metres from their origin.
#pragma once

#include <array>
#include <vector>

#include "math/vec3.h"

namespace lumi::baker
{

// Squares and differences stay exact enough in binary64 and finite in binary32.
inline constexpr double kMaxCoordinate = 1e15;

using Point = std::array<double, 3>;

// In binary32, and what to add to them.
struct CentredPositions {
    std::vector<Vec3> positions;
    Point origin = {0, 0, 0};
};

// The origin stays that of the file unless the points lie so far from it that binary32 loses their shape.
CentredPositions centred(const std::vector<Point>& points);

}  // namespace lumi::baker
