// SPDX-License-Identifier: MIT
// One lattice over a tile: coordinates at its four corners, bilinear in between.
//
// Tiles lie on a grid that the image fixes, so that a stripe draws the same pixels whatever rows it begins and ends
// with. They take the sphere's inside; spans (span_walker.h) the rim and the caps.
#pragma once

#include "lumi/detail/stepping/chart.h"
#include "lumi/detail/stepping/hits.h"

namespace lumi
{

// The exact hits around a tile; the right and lower ones are those of the tiles beside it.
struct TileCorners {
    const SpanNode *top_left, *top_right, *bottom_left, *bottom_right, *centre;
};

class TileWalker
{
public:
    explicit TileWalker(SpanTrack& track) : track_(track) {}

    // Sets up a tile 2^width_log2 pixels wide, side() for its first row; false where it neither lies within a pole's
    // pattern nor outside the caps, or turns by more than 1/16 turn.
    bool prepare(const TileCorners& corners, int width_log2);
    // Goes on to the part of a row further down; 0 begins the tile's first row.
    void advance(int32_t rows)
    {
        track_.side.move_down(down_, rows);
        if (track_.side.cap != nullptr) follow_cap();
    }
    // The highest index under the tile that prepare() set up.
    int32_t highest(int32_t width) const;

    SpanSide& side() const { return track_.side; }
    const SpanDown& down() const { return down_; }

private:
    // From edge to edge; `twist` is what `across` changes by.
    struct TileChange {
        LatticePoint across, down, twist;
    };

    bool prepare_cells(const TileCorners& corners, int width_log2);
    bool prepare_cap(const TileCorners& corners, int width_log2);
    void set(const LatticePoint& begin, const TileChange& by, int width_log2);
    void follow_cap();

    SpanTrack& track_;
    SpanDown down_{};
    int32_t triangle_ = 0;  // over a cap, where rows begin to look for theirs
};

}  // namespace lumi
