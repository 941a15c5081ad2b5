// SPDX-License-Identifier: MIT
// One lattice along a scanline, where tiles do not go: coordinates at the ends of a span, stepped in between; and how
// long spans are next to the sphere's rim, where hits turn fast.
#pragma once

#include "lumi/chord/detail/stepping/zone_map.h"

namespace lumi::detail
{

inline constexpr int kMaxSpanLog2 = 4;  // spans are up to 16 pixels long

// 1/n rounded down, n = 1 .. 16.
inline int32_t reciprocal_q14(int32_t n)
{
    static constexpr uint16_t kReciprocalQ14[17] = {0,    16384, 8192, 5461, 4096, 3276, 2730, 2340, 2048,
                                                    1820, 1638,  1489, 1365, 1260, 1170, 1092, 1024};
    return kReciprocalQ14[n];
}

// A coordinate's step a pixel along a span of 1 .. 16 pixels, from its difference in Q16, where that is steppable.
// Short of the exact one by less than 2^-10 of itself: no span overshoots its end by more than 2^-12 of a cell.
inline int32_t step_of(int32_t difference_q16, int32_t length_px)
{
    return ((difference_q16 >> 4) * reciprocal_q14(length_px)) >> 10;
}

// Whether step_of() takes a difference: less than 2^5 cells.
inline bool is_steppable(int32_t difference_q16)
{
    constexpr uint32_t kLimit = 1u << 21;
    return static_cast<uint32_t>(difference_q16) + kLimit < 2 * kLimit;
}

class SpanLengths
{
public:
    // Spans have at most `longest_px` pixels, 2 .. 16.
    explicit SpanLengths(int32_t longest_px)
        : longest_(longest_px), first_(longest_px < 16 ? 2 : 3), second_(first_ + (longest_px < 13 ? longest_px : 13))
    {
    }

    // The length of a span between two knots that begins `from_left` pixels from the scanline's first one, and
    // `from_right` > 0 from its last one; at most `room` > 0.
    int32_t length(int32_t from_left, int32_t from_right, int32_t room) const
    {
        const int32_t left = from_left < first_ ? first_ - from_left : second_ - from_left;
        const int32_t right = from_right - (from_right > second_ ? second_ : from_right > first_ ? first_ : 0);
        const int32_t eighth = 1 + ((from_left + from_right) >> 3);  // a small sphere has short spans
        int32_t length = eighth < longest_ ? eighth : longest_;
        if (left > 0 && left < length) length = left;
        if (right < length) length = right;
        return room < length ? room : length;
    }

    // At the rim a hit moves like the root s of the distance from it: along a span from s0 to s1 the mean of s is
    // (s1 - s0)²/(6·(s0 + s1)) more than (s0 + s1)/2; with s² the distance to the rim, about length/(12·(s0² + s1²)) of
    // the way. How far a span is to be moved for that, in its steps, by the pixels between the rim and its nearer end:
    // by less than an eighth of its length; spans of one or two pixels lie where they are.
    static int32_t shift_q8(int32_t from_left, int32_t from_right, int32_t length)
    {
        if (length < 3) return 0;
        return share_q8(from_left, length) - share_q8(from_right, length);
    }

private:
    // 256·length²/(12·(s0² + s1²)) with s0² + s1² = 2·distance + length, by 341/1024 = 1/3.
    static int32_t share_q8(int32_t distance, int32_t length)
    {
        const int32_t sum = (2 * distance + length + 1) >> 2;
        return sum > 16 ? 0 : (length * length * reciprocal_q14(sum > 0 ? sum : 1) * 341) >> 20;
    }

    int32_t longest_, first_, second_;
};

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
