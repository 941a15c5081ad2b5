// SPDX-License-Identifier: MIT
// FLIP: what an observer notices who flips between two pictures. Andersson, Nilsson, Akenine-Möller, Oskarsson,
// Åström, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM CGIT 3(2), 2020: the version for
// low dynamic range, written from its formulas.
#pragma once

#include "image/picture.h"

namespace lumi::tools
{

// The paper has so many pixels a degree of the observer's view: a screen 0.7 m wide with 3840 pixels, seen from 0.7 m.
inline constexpr double kFlipPixelsPerDegree = 67.0206;

// The error of every pixel, 0 (alike) to 1. Pixels beyond a border are those at it.
// Precondition: same_size(a, b), at least one pixel, pixels_per_degree > 0.
Plane<double> flip_map(const Picture& reference, const Picture& test, double pixels_per_degree = kFlipPixelsPerDegree);

// The mean of the map.
double flip(const Picture& reference, const Picture& test, double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace lumi::tools
