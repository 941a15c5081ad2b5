// SPDX-License-Identifier: MIT
// How long spans are next to the sphere's rim, where hits turn fast, and where they lie between their ends.
#pragma once

#include <stdint.h>

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
    // Spans of at most `longest_px` pixels, 2 .. 16.
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
    static int32_t share_q8(int32_t distance, int32_t length)
    {
        const int32_t sum = (2 * distance + length + 1) >> 2;
        return sum > 16 ? 0 : (length * length * reciprocal_q14(sum > 0 ? sum : 1) * 341) >> 20;
    }

    int32_t longest_, first_, second_;
};

}  // namespace lumi::detail
