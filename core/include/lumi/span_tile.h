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

    // Sets up a tile 2^width_log2 pixels wide; false where it reaches a pole's cap or turns by more than 1/16 turn.
    bool prepare(const TileCorners& corners, int width_log2);
    // Makes side() the part of row `row`, 0 .. kTileRows - 1.
    void begin(int32_t row)
    {
        SpanSide& side = track_.side;
        side.u_q16 += row * down_.u_q16;
        side.v_q16 += row * down_.v_q16;
        side.du_q16 += row * down_.du_q16;
        side.dv_q16 += row * down_.dv_q16;
    }
    void next_row() { begin(1); }
    // The highest index under the tile that prepare() set up.
    int32_t highest(int32_t width) const;

    const SpanSide& side() const { return track_.side; }

private:
    SpanTrack& track_;
    struct {
        int32_t u_q16, v_q16, du_q16, dv_q16;
    } down_{};  // how the row's values change from one row to the next
};

}  // namespace lumi
