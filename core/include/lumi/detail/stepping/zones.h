// SPDX-License-Identifier: MIT
// Lattice coordinates along a span: what lattice.h evaluates for one direction, stepped linearly between two.
//
// Within a zone the coordinates (u, v) of a direction are linear in its longitude and its height, so a span needs them
// at its ends only. One zone serves a whole span: beyond its border a zone's cells are still the next zone's.
#pragma once

#include "lumi/lattice.h"
#include "lumi/detail/stepping/polar_cap.h"
#include "lumi/detail/stepping/hits.h"

namespace lumi
{

// Larger lattices are drawn by the exact renderer: 16-bit viewing vectors no longer resolve their cells.
inline constexpr uint32_t kMaxSpanLattice = 65536;
// Smaller ones too: they have no zones to speak of.
inline constexpr uint32_t kMinSpanLattice = 64;
// The lattice's coordinates end where the pole's own pattern begins (a real-valued index): F_8 = 21, and one for the
// rounding of heights.
inline constexpr int32_t kSpanCapHeight = 22;
// Up to here (a real-valued index) the pole's own pattern may go on: tiles and spans that cross the cap's border take
// it.
inline constexpr int32_t kSpanCapReach = 47;
inline constexpr uint32_t kMinReachLattice = 256;  // smaller ones end their caps at kSpanCapHeight

inline constexpr int kMaxSpanLog2 = 4;  // spans are up to 16 pixels long

inline constexpr int kFirstSpanZone = 6;  // the one that a cap reaches into, for every size
inline constexpr int kSpanZones = 8;      // 6 .. 13

// A zone's constants; heights are |z|, Q30, so that a zone is found by comparisons alone.
struct SpanZone {
    int32_t begin_z_q30;              // the zone holds |z| below this, down to the next zone's
    int32_t obtuse_z_q30;             // its steps form an obtuse angle below this ...
    int32_t obtuse_index_q10;         // ... that is from this height on, as a real-valued index
    int16_t scale_u, scale_v, shift;  // height to u, v: mantissas below 2^14, then a shift right
    int16_t number;                   // k: its steps are F_k and F_k+1
    int32_t origin_u_q16, origin_v_q16;
};

// The zones of one lattice, computed once per stripe. 248 bytes.
struct SpanLattice {
    int32_t size;
    int32_t cap_z_q30;       // |z| at kSpanCapHeight
    int32_t reach_z_q30;     // |z| at kSpanCapReach, or cap_z_q30
    int32_t mirror_turns20;  // longitude of point n-1, Q20: the mirror image of longitude p is mirror - p
    int32_t mirror_cos_q15, mirror_sin_q15;
    int32_t step_z_q30;  // 1/n: half a point's share of the height
    SpanZone zone[kSpanZones];

    explicit SpanLattice(const Lattice& lattice);
};

// Tiles are this high.
inline constexpr int kTileRowsLog2 = 3;
inline constexpr int32_t kTileRows = 1 << kTileRowsLog2;

// How a side's values change from one row of a tile to the next.
struct SpanDown {
    int32_t u_q16, v_q16, du_q16, dv_q16;
};

// One side (origins or directions) of the span being drawn: coordinates of its first pixel and their steps, Q16, in a
// basis whose steps form an obtuse angle, so that the triangle of a cell is decided by fu > fv. In a pole's cap the
// polar pattern takes their place; its indices count from the pole, and `first` is their step.
struct SpanSide {
    int32_t u_q16, v_q16, du_q16, dv_q16;
    int32_t first, second;  // index steps of u and v, negative where mirrored or reflected
    int32_t base;           // index of (0, 0)
    // The cells whose diagonal is not the sum of both steps: those whose lowest corner, first·a + second·b, is below
    // `flip` where flip_mask is 0, and at `flip` or above where it is -1 (see SpanSteps). Decided cell by cell, as the
    // exact renderer does.
    int32_t flip, flip_mask;
    const SpanZone* zone;
    int32_t z_q30;  // at its first pixel
    SpanCap* cap;   // over a pole's cap the way through it, which drawing walks; else null
    bool uniform;   // no flipped cell lies under the span

    // Whether `first` runs against the zone's step.
    bool reflected() const { return (first ^ second) < 0; }
    // The highest index that the corners under the span's `length` pixels can have.
    int32_t highest(int32_t length) const;
    void move_down(const SpanDown& down, int32_t rows)
    {
        u_q16 += rows * down.u_q16;
        v_q16 += rows * down.v_q16;
        du_q16 += rows * down.du_q16;
        dv_q16 += rows * down.dv_q16;
    }
};

}  // namespace lumi
