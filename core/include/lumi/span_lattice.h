// SPDX-License-Identifier: MIT
// Lattice coordinates along a span: what lattice.h evaluates for one direction, stepped linearly between two.
//
// Within a zone the coordinates (u, v) of a direction are linear in its longitude and its height, so a span needs them
// at its ends only. One zone serves a whole span: beyond its border a zone's cells are still the next zone's.
#pragma once

#include "lumi/lattice.h"
#include "lumi/span_node.h"

namespace lumi
{

// Larger lattices are drawn by the exact renderer: 16-bit viewing vectors no longer resolve their cells.
inline constexpr uint32_t kMaxSpanLattice = 65536;
// Smaller ones too: they have no zones to speak of.
inline constexpr uint32_t kMinSpanLattice = 64;
// The lattice's coordinates end where the pole's own pattern begins (a real-valued index).
inline constexpr int32_t kSpanCapHeight = 21;

inline constexpr int kFirstSpanZone = 3;
inline constexpr int kSpanZones = 12;  // zones 3 .. 14

struct SpanZone {
    int32_t first, second;     // F_k, F_k+1
    uint32_t begin_q30;        // 1 - z² where the zone begins
    uint32_t obtuse_q30;       // 1 - z² from which its steps form an obtuse angle
    uint32_t low_q30;          // 1 - |z| above which all corners of a cell have indices on this side of the pole
    int32_t scale_u, scale_v;  // height to u, v: mantissas below 2^14 ...
    int32_t shift;             // ... to be shifted right by this
    int32_t origin_u_q16, origin_v_q16;
};

// The zones of one lattice, computed once per stripe. 440 bytes.
struct SpanLattice {
    uint32_t size;
    uint32_t mirror_turns32;  // longitude of point n-1: the mirror image of longitude p is mirror - p
    uint32_t cap_q30;         // 1 - |z| at kSpanCapHeight
    SpanZone zone[kSpanZones];

    explicit SpanLattice(const Lattice& lattice);
};

// One side (origins or directions) of the span being drawn: coordinates of its first pixel and their steps, Q16, in a
// basis whose steps form an obtuse angle, so that the triangle of a cell is decided by fu > fv.
struct SpanSide {
    int32_t u_q16, v_q16, du_q16, dv_q16;
    int32_t first, second;  // index steps of u and v, negative where mirrored or reflected
    int32_t base;           // index of (0, 0)
    uint32_t sine2_q30;     // 1 - z² at its middle
    const SpanZone* zone;

    // The highest index that the corners of the cells under the span's `length` pixels can have.
    int32_t highest(int32_t length) const;
};

// Follows one lattice along a row.
class SpanWalker
{
public:
    explicit SpanWalker(const SpanLattice& lattice) : lattice_(lattice) {}

    // Begins a row at a hit.
    void begin(const SpanHit& hit);
    // Extends to the next hit, 2^length_log2 pixels on; false if the span comes too close to a pole or turns by more
    // than 1/16 turn, in which case the walker moves on all the same and `out` is not set.
    bool advance(const SpanHit& next, int length_log2, SpanSide& out);

private:
    struct Position {
        int32_t longitude_q20;  // unwrapped along the row
        int32_t z_q30;
    };

    int zone_at(uint32_t sine2_q30) const;
    void coordinates(const Position& p, int32_t& u_q16, int32_t& v_q16) const;

    const SpanLattice& lattice_;
    uint32_t longitude_turns32_ = 0;
    Position at_{0, 0};
    int zone_ = 0;
    bool mirrored_ = false;
    bool known_ = false;  // u_, v_ hold at_ in zone_
    int32_t u_q16_ = 0, v_q16_ = 0;
};

}  // namespace lumi
