// SPDX-License-Identifier: MIT
// One lattice along the rows at the rim and over the caps: coordinates at the ends of a span, stepped in between.
#pragma once

#include "lumi/detail/stepping/chart.h"
#include "lumi/detail/stepping/hits.h"

namespace lumi
{

// Follows one lattice along a row. `at` is always the node that begin() or the last commit() stood for.
class SpanWalker
{
public:
    explicit SpanWalker(SpanTrack& track) : track_(track) {}

    // Begins at a node: a row, or anew.
    void begin(const SpanNode& at);
    // Sets side() for the span up to the node `length` pixels on, 1 .. 16, and returns `length`; or returns how long to
    // make it at most, 0 .. length - 1, as it enters or leaves a pole's cap or turns by more than 1/16 turn.
    int32_t prepare(const SpanNode& at, const SpanNode& next, int32_t length);
    // Moves the span that prepare() set up by a share of a pixel's step (SpanRamp::shift_q8). Not over caps, nor where the
    // chart could end.
    void shift(int32_t share_q8);
    // Moves on to the node that was prepared for, once the span is drawn.
    void commit()
    {
        longitude_q20_ = next_longitude_q20_;
        set_begin(next_);
    }

    SpanSide& side() const { return track_.side; }

private:
    void set_begin(const LatticePoint& p)
    {
        track_.side.u_q16 = p.u_q16;
        track_.side.v_q16 = p.v_q16;
    }
    bool reaches_cap(const SpanHit& at, const SpanHit& next) const;
    int32_t prepare_cap(const SpanNode& at, const SpanNode& next, int32_t length);

    SpanTrack& track_;
    int32_t longitude_q20_ = 0, next_longitude_q20_ = 0;  // unwrapped along the row
    LatticePoint next_{};
    int32_t next_z_q30_ = 0;
};

}  // namespace lumi
