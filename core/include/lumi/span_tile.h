// SPDX-License-Identifier: MIT
// One lattice over a tile: coordinates at its four corners, bilinear in between.
//
// Tiles lie on a grid that the image fixes, so that a stripe draws the same pixels whatever rows it begins and ends
// with. They take the sphere's inside; spans (span_walker.h) the rim and the caps.
#pragma once

#include "lumi/span_chart.h"
#include "lumi/span_node.h"

namespace lumi
{

inline constexpr int kTileRowsLog2 = 3;
inline constexpr int32_t kTileRows = 1 << kTileRowsLog2;

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
        move_down(track_.side, rows);
        if (track_.side.cap != nullptr) follow_cap();
    }
    // The highest index under the tile that prepare() set up.
    int32_t highest(int32_t width) const;

    const SpanSide& side() const { return track_.side; }

private:
    struct TilePoints {
        LatticePoint top_left, top_right, bottom_left, bottom_right, centre;
    };

    bool prepare_cells(const TileCorners& corners, int width_log2);
    bool prepare_cap(const TileCorners& corners, int width_log2);
    void set_bilinear(const TilePoints& at, int width_log2);
    void move_down(SpanSide& side, int32_t rows) const
    {
        side.u_q16 += rows * down_.u_q16;
        side.v_q16 += rows * down_.v_q16;
        side.du_q16 += rows * down_.du_q16;
        side.dv_q16 += rows * down_.dv_q16;
    }
    void follow_cap();

    SpanTrack& track_;
    struct {
        int32_t u_q16, v_q16, du_q16, dv_q16;
    } down_{};              // how the row's values change from one row to the next
    int32_t triangle_ = 0;  // over a cap, where rows begin to look for theirs
};

}  // namespace lumi
