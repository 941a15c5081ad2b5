// SPDX-License-Identifier: MIT
// What hides from an origin: a depth for each block of grid points.
#pragma once

#include "guided/chart_mask.h"

namespace lumi::baker
{

// The farthest surface that the origin sees in each block or next to it, and a margin; blocks without any hide nothing.
// `farthest` holds a distance for each texel of `rows`, 0 where the origin sees no surface.
PackedChart chart_occlusion(const ChartMask& mask, const ChartRows& rows, const std::vector<float>& farthest);

}  // namespace lumi::baker
