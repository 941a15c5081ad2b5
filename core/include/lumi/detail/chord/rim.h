// SPDX-License-Identifier: MIT
// Both lattices along one side of the sphere's rim, over a tile's rows, without exact hits for each row.
//
// At the rim hits move like the root of the distance from it: they are smooth functions of the row and of the half
// chord s (camera.h). Along a row, coordinates are a parabola in s through three exact hits; its coefficients are
// linear between the tile's first row and the one below its last. Like tiles, rims depend on the image alone.
#pragma once

#include "lumi/detail/stepping/chart.h"
#include "lumi/detail/stepping/hits.h"

namespace lumi
{

// Of one row's knots: distances between them and their reciprocals.
struct RimSpacing {
    int32_t outer_q15;
    CoarseReciprocal outer, inner, both;
};

// How far from the middle knot a rim may be drawn.
struct RimReach {
    int32_t low_q15, high_q15;
};

// A coordinate at d from the middle knot: value + d·(slope + d·bend), d in Q15.
struct RimParabola {
    int32_t value_q16;
    int16_t slope_q5, bend_q5;  // in Q16 cells a unit of d: less than 2^14

    int32_t at(int32_t d_q15) const { return value_q16 + (((slope_q5 + ((bend_q5 * d_q15) >> 15)) * d_q15) >> 5); }
};

// The same for the tile's first row, what it differs by below the last row, and for the row being drawn.
struct RimRows {
    RimParabola top, rise, row;

    void go_to(int32_t row_of_tile);
};

// One lattice.
class RimCurve
{
public:
    explicit RimCurve(SpanTrack& track) : track_(track) {}

    // Chooses the chart of the first row's middle knot; false over a cap.
    bool begin(const SpanNode& middle);
    // A knot's coordinates; false where they lie too far around the pole.
    bool place(const SpanNode& node, LatticePoint& at);
    // Sets up all rows; false where the chart does not hold all that the rim may reach.
    bool fit(const LatticePoint at[2][3], const RimSpacing spacing[2], const RimReach& reach);
    void begin_row(int32_t row_of_tile, int32_t d_q15);
    // Sets the side of the track for a span to the pixel at `d`, `length` pixels on, moved by a share of a pixel's
    // step.
    void prepare_span(int32_t d_q15, int32_t length, int32_t share_q8);

private:
    bool stays_in_chart(const RimReach& reach);

    SpanTrack& track_;
    RimRows u_, v_;
    uint32_t longitude_turns32_;  // of the middle knot
    LatticePoint next_;           // where the next span begins
};

class SpanRim
{
public:
    SpanRim(SpanTrack& front, SpanTrack& back) : front_(front), back_(back) {}

    // Sets up both lattices between the tiles and the outline; false where the rim must be drawn without. `rays` begin
    // at the tiles' column of their first row; the outline's pixels of that row and the one below the last lie
    // `outer_px` to the right of it.
    bool prepare(const NodeEvaluator& nodes, const RayRow& rays, const int32_t outer_px[2]);
    // Whether its rows turn so far, by more than 1/16 turn, that spans must be shorter.
    bool turns_far() const { return turns_far_; }
    // Begins a part of a row, 0 .. kTileRows - 1, at a pixel of this half chord.
    void begin_row(int32_t row_of_tile, int32_t half_chord_q15);
    // Sets both sides for the span up to the pixel of this half chord, `length` pixels on; moves it by `share_q8` of a
    // pixel's step, less than an eighth of the span's length.
    void prepare_span(int32_t half_chord_q15, int32_t length, int32_t share_q8);

private:
    struct Knots;

    bool place(const NodeEvaluator& nodes, const Knots& knots, const RimSpacing spacing[2]);
    int32_t from_middle_q15(int32_t half_chord_q15) const;

    RimCurve front_, back_;
    RimReach reach_{};
    bool turns_far_ = false;
    int32_t top_q15_ = 0, rise_q15_ = 0, middle_q15_ = 0;  // half chord of the middle knot, as in RimRows
};

}  // namespace lumi
