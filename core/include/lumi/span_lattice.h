// SPDX-License-Identifier: MIT
// Lattice coordinates along a span: what lattice.h evaluates for one direction, stepped linearly between two.
//
// Within a zone the coordinates (u, v) of a direction are linear in its longitude and its height, so a span needs them
// at its ends only. One zone serves a whole span: beyond its border a zone's cells are still the next zone's.
#pragma once

#include "lumi/lattice.h"
#include "lumi/span_cap.h"
#include "lumi/span_node.h"

namespace lumi
{

// Larger lattices are drawn by the exact renderer: 16-bit viewing vectors no longer resolve their cells.
inline constexpr uint32_t kMaxSpanLattice = 65536;
// Smaller ones too: they have no zones to speak of.
inline constexpr uint32_t kMinSpanLattice = 64;
// The lattice's coordinates end where the pole's own pattern begins (a real-valued index): F_8 = 21, and one for the
// rounding of heights.
inline constexpr int32_t kSpanCapHeight = 22;

inline constexpr int kFirstSpanZone = 3;
inline constexpr int kSpanZones = 12;  // zones 3 .. 14

struct SpanZone {
    int32_t first, second;     // F_k, F_k+1
    uint32_t begin_q30;        // 1 - z² where the zone begins
    uint32_t obtuse_q30;       // 1 - z² from which its steps form an obtuse angle
    // 1 - |z| from which no corner of a cell lies beyond the pole, where the steps are acute and where obtuse.
    uint32_t low_acute_q30, low_obtuse_q30;
    int32_t scale_u, scale_v;  // height to u, v: mantissas below 2^14 ...
    int32_t shift;             // ... to be shifted right by this
    int32_t origin_u_q16, origin_v_q16;
};

// The zones of one lattice, computed once per stripe. 460 bytes.
struct SpanLattice {
    uint32_t size;
    uint32_t mirror_turns32;  // longitude of point n-1: the mirror image of longitude p is mirror - p
    uint32_t cap_q30;         // 1 - |z| at kSpanCapHeight
    int32_t mirror_cos_q15, mirror_sin_q15;
    SpanZone zone[kSpanZones];

    explicit SpanLattice(const Lattice& lattice);
};

// One side (origins or directions) of the span being drawn: coordinates of its first pixel and their steps, Q16, in a
// basis whose steps form an obtuse angle, so that the triangle of a cell is decided by fu > fv. In a pole's cap the
// polar pattern takes their place; its indices count from the pole, and `first` is their step.
struct SpanSide {
    bool in_cap;
    int32_t first, second;  // index steps of u and v, negative where mirrored or reflected
    int32_t base;           // index of (0, 0)
    int32_t u_q16, v_q16, du_q16, dv_q16;
    uint32_t sine2_q30;  // 1 - z² at its middle
    const SpanZone* zone;
    SpanCap cap;

    // The highest index that the corners under the span's `length` pixels can have.
    int32_t highest(int32_t length) const;
};

// Follows one lattice along a row.
class SpanWalker
{
public:
    explicit SpanWalker(const SpanLattice& lattice) : lattice_(lattice) {}

    // Begins a row at a hit.
    void begin(const SpanHit& hit);
    // Sets `out` for the span up to the hit 2^length_log2 pixels on; false if the span must be shorter: it enters or
    // leaves a pole's cap, or turns by more than 1/16 turn.
    bool prepare(const SpanHit& next, int length_log2, SpanSide& out);
    // Moves on to the hit that was prepared for.
    void commit();
    // Sets `out` for the one pixel at the current hit; false if only the exact renderer can draw it.
    bool prepare_pixel(SpanSide& out) { return prepare(at_.hit, 0, out); }

private:
    struct Position {
        SpanHit hit;
        int32_t longitude_q20;  // unwrapped along the row
        uint32_t from_pole_q30;

        int32_t u_q16, v_q16;  // where the zone is known
    };

    int zone_at(uint32_t sine2_q30) const;
    Position position(const SpanHit& hit, int32_t longitude_q20) const;
    void set_coordinates(Position& p) const;
    void prepare_cap(int length_log2, SpanSide& out) const;
    void prepare_chart(int length_log2, SpanSide& out);

    const SpanLattice& lattice_;
    Position at_{}, next_{};
    int zone_ = 0;
    int32_t triangle_ = 0;
    bool mirrored_ = false;
    bool known_ = false;  // at_ has its coordinates in zone_
};

}  // namespace lumi
