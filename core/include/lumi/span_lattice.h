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

inline constexpr int kMaxSpanLog2 = 4;  // spans are up to 16 pixels long

inline constexpr int kFirstSpanZone = 6;  // the one that a cap reaches into, for every size
inline constexpr int kSpanZones = 8;      // 6 .. 13

// A zone's constants; heights are |z|, Q30, so that a zone is found by comparisons alone.
struct SpanZone {
    int32_t begin_z_q30;              // the zone holds |z| below this, down to the next zone's
    int32_t obtuse_z_q30;             // its steps form an obtuse angle below this ...
    int32_t obtuse_index_q10;         // ... that is from this height on, as a real-valued index
    int16_t scale_u, scale_v, shift;  // height to u, v: mantissas below 2^14, then a shift right
    int32_t origin_u_q16, origin_v_q16;
};

// The zones of one lattice, computed once per stripe. 248 bytes.
struct SpanLattice {
    int32_t size;
    int32_t cap_z_q30;       // |z| at kSpanCapHeight
    int32_t mirror_turns20;  // longitude of point n-1, Q20: the mirror image of longitude p is mirror - p
    int32_t mirror_cos_q15, mirror_sin_q15;
    int32_t step_z_q30;  // 1/n: half a point's share of the height
    SpanZone zone[kSpanZones];

    explicit SpanLattice(const Lattice& lattice);
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
    bool in_cap;
    bool uniform;  // no flipped cell lies under the span
    SpanCap cap;

    // Whether `first` runs against the zone's step.
    bool reflected() const { return (first ^ second) < 0; }
    // The highest index that the corners under the span's `length` pixels can have.
    int32_t highest(int32_t length) const;
};

// Follows one lattice along the rows of a stripe. `at` is always the node that begin() or the last commit() stood for.
class SpanWalker
{
public:
    SpanWalker(const SpanLattice& lattice, SpanHit SpanNode::*hit) : lattice_(lattice), hit_(hit) {}

    // Begins at a node: a row, or anew.
    void begin(const SpanNode& at);
    // Sets side() for the span up to the node 2^length_log2 pixels on and returns 0; or returns how often the span must
    // be halved at least, as it enters or leaves a pole's cap or turns by more than 1/16 turn.
    int prepare(const SpanNode& at, const SpanNode& next, int length_log2);
    // Bends the span that prepare() set up: from the change of its steps since the span before, a parabola, of which
    // two straight halves are drawn. Makes side() the first half where that matters, and says whether it does; call it
    // once a span, then second_half() with the first one's length. Not `allowed` to, it only takes note of the span.
    bool bend(int length_log2, bool allowed)
    {
        if (allowed && length_log2 == kMaxSpanLog2 && before_.length_log2 >= kMaxSpanLog2 - 2) return bend_longest();
        note(length_log2);
        return false;
    }
    void second_half(int32_t first_length)
    {
        side_.u_q16 += first_length * side_.du_q16;
        side_.v_q16 += first_length * side_.dv_q16;
        side_.du_q16 = 2 * before_.du_q16 - side_.du_q16;
        side_.dv_q16 = 2 * before_.dv_q16 - side_.dv_q16;
    }
    // Moves on to the node that was prepared for, once the span is drawn.
    void commit()
    {
        before_.longitude_q20 = longitude_q20_;
        before_.z_q30 = side_.z_q30;
        longitude_q20_ = next_longitude_q20_;
        side_.u_q16 = next_u_q16_;
        side_.v_q16 = next_v_q16_;
    }

    const SpanSide& side() const { return side_; }

private:
    // (u, v) as linear functions of a hit's longitude and z, hemisphere and reflection included.
    struct Chart {
        int32_t u_q16, v_q16, u_longitude, v_longitude, u_z, v_z, shift;
    };

    // The span before: where it began, its steps in this one's chart and its length; none after a row's begin or a cap.
    struct Before {
        int32_t longitude_q20, z_q30, du_q16, dv_q16;
        int length_log2 = -1;
    };

    void set_chart(int32_t z_q30);
    void rechart_before();
    bool bend_longest();
    void note(int length_log2)
    {
        before_.du_q16 = side_.du_q16;
        before_.dv_q16 = side_.dv_q16;
        before_.length_log2 = side_.in_cap ? -1 : length_log2;
    }
    bool holds(int32_t z_q30) const { return z_q30 >= low_z_q30_ && z_q30 < high_z_q30_; }
    void set_coordinates(int32_t longitude_q20, int32_t z_q30, int32_t& u_q16, int32_t& v_q16) const;
    void prepare_cap(const SpanNode& at, const SpanNode& next, int length_log2);

    const SpanLattice& lattice_;
    SpanHit SpanNode::*hit_;
    SpanSide side_{};
    Chart chart_{};
    int32_t low_z_q30_ = 0, high_z_q30_ = 0;  // signed z range in which the chart is exact; empty: there is none yet
    int32_t uniform_low_z_q30_ = 0, uniform_high_z_q30_ = 0;  // between these no cell is flipped
    int32_t limit_z_q30_ = 0;                                 // |z| up to which it may be used at all
    int zone_ = 0;
    int32_t longitude_q20_ = 0, next_longitude_q20_ = 0;  // unwrapped along the row
    int32_t next_u_q16_ = 0, next_v_q16_ = 0;
    Before before_{};
};

}  // namespace lumi
