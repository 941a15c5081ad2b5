// SPDX-License-Identifier: MIT
// One lattice along a scanline, where tiles do not go: coordinates at the ends of a span, stepped in between.
#pragma once

#include "lumi/chord/detail/stepping/span_length.h"
#include "lumi/chord/detail/stepping/zone_map.h"

namespace lumi::detail
{

// `at` is always the pixel that begin() or the last commit() stood for.
class LineWalker
{
public:
    explicit LineWalker(LatticeTrack& track) : track_(track) {}

    // Begins at a pixel: a scanline, or anew. Leaves the track's line as it is.
    void begin(const HitPair& at);
    // Sets the track's line for the span up to the pixel `length` on, 1 .. 16, and returns `length`; or returns how
    // long to make it at most, 0 .. length - 1, as it comes near a pole or leaves it, or turns by more than 1/16 turn.
    int32_t prepare(const HitPair& at, const HitPair& next, int32_t length);
    // Moves the line that prepare() set up by a share of a pixel's step (SpanLengths::shift_q8). Not over a pole, nor
    // where the map could end.
    void shift(int32_t share_q8);
    // Moves on to the pixel that was prepared for.
    void commit()
    {
        longitude_q20_ = next_longitude_q20_;
        place_ = next_place_;
    }

private:
    bool is_over_pole(const Hit& at, const Hit& next) const;
    int32_t prepare_polar(const HitPair& at, const HitPair& next, int32_t length);

    LatticeTrack& track_;
    bool in_plane_ = false;                               // places are of the polar pattern's plane
    int32_t longitude_q20_ = 0, next_longitude_q20_ = 0;  // unwrapped along the scanline
    LatticePoint place_{}, next_place_{};
    int32_t z_q30_ = 0, next_z_q30_ = 0;  // at the prepared line's ends
};

}  // namespace lumi::detail
