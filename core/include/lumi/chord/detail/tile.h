// SPDX-License-Identifier: MIT
// One lattice over a tile: coordinates at its four corners, bilinear in between.
//
// Tiles lie on a grid that the image fixes, so that a stripe draws the same pixels whatever scanlines it begins and
// ends with. They take the sphere's inside; spans (walker.h) the rim and the poles.
#pragma once

#include "lumi/chord/detail/stepping/zone_map.h"

namespace lumi::detail
{

// Tiles are this high.
inline constexpr int kTileHeightLog2 = 3;
inline constexpr int32_t kTileHeight = 1 << kTileHeightLog2;

// The exact hits around a tile; the right and lower ones are those of the tiles beside it.
struct TileCorners {
    const HitPair *top_left, *top_right, *bottom_left, *bottom_right, *centre;
};

class TileWalker
{
public:
    explicit TileWalker(LatticeTrack& track) : track_(track) {}

    // Sets the track's line for the first scanline of a tile 2^width_log2 pixels wide; false where it comes near a pole
    // or turns by more than 1/16 turn. Places are within 0.25 of a cell of each pixel's own.
    bool prepare(const TileCorners& corners, int width_log2);
    // How the line changes from scanline to scanline.
    const LineChange& down() const { return down_; }
    // The highest index under the tile that prepare() set up.
    int32_t highest(int32_t width) const;

private:
    LatticeTrack& track_;
    LineChange down_{};
};

}  // namespace lumi::detail
