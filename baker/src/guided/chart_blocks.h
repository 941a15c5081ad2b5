// SPDX-License-Identifier: MIT
// Texels of charts in blocks of 2×2 grid points, each the nearest of 255 blocks that a group of origins shares: vector
// quantisation (GuidedTexel::vq8).
#pragma once

#include "guided/chart_palettes.h"

namespace lumi::baker
{

// The rows of blocks over rows of texels: block (a, b) holds grid points (2a, 2b) to (2a + 1, 2b + 1).
ChartRows block_rows(const ChartRows& rows);

// As palettes_of(), of charts with these rows; texels are those of block_rows(). A missing texel beside known ones
// shows what its block says; block 0 holds missing ones alone.
Palettes blocks_of(const std::vector<ChartColours>& charts, const std::vector<ChartRows>& rows, bool differences,
                   Job& job);

}  // namespace lumi::baker
