// SPDX-License-Identifier: MIT
// Both sides of a span through the lattice's cells at once: a side in each half of a word, the origins in the upper
// one, the directions in the lower one.
//
// Coordinates count cells from the one in which the span begins, Q12, in 16 bits: pixels may be up to 0.46 cells apart,
// and a span's 15 steps reach less than eight cells. Steps are rounded to Q12, which moves the last pixel by at most
// 0.002 cells: less than a point's index, so that no corner leaves the lattice (SpanChart keeps one to spare).
// Two halves are added as one word: a lower half below zero takes 2^-12 cells from the upper one, on every core.
#pragma once

#include "lumi/span_nine.h"
#include "lumi/span_pair_steps.h"

namespace lumi
{

// Whether a side's cell is divided by the difference of its steps.
struct PairFlip {
    WordPair<int32_t> border_and_mask;
    LUMI_ALWAYS_INLINE bool is_flipped(int32_t offset) const
    {
        const WordPair<int32_t> flip = reload(border_and_mask);
        return ((offset - flip.a) ^ flip.b) < 0;
    }
};

// Whether the span's steps are few and short enough: from 4095/4096 of a cell 15 of them end within [-8, 8).
inline bool can_follow(const SpanSide& origins, const SpanSide& directions, int32_t length)
{
    constexpr int32_t kMostPixels = 16;
    constexpr uint32_t kBelow = 34952;  // steps from -34952/65536 on
    constexpr uint32_t kRange = 0x10000;
    const auto above = [](int32_t d_q16) { return static_cast<uint32_t>(d_q16) + kBelow; };
    return length <= kMostPixels && (above(origins.du_q16) | above(origins.dv_q16) | above(directions.du_q16) |
                                     above(directions.dv_q16)) < kRange;
}

// Coordinates of both sides in the first pixel's cells, and their steps.
inline uint32_t pair_begin(int32_t origin_q16, int32_t direction_q16)
{
    const auto fraction = [](int32_t q16) {
        return (static_cast<uint32_t>(q16) >> (16 - kPairBits)) & ((1u << kPairBits) - 1);
    };
    return (fraction(origin_q16) << 16) + fraction(direction_q16);
}
inline uint32_t pair_step(int32_t origin_q16, int32_t direction_q16)
{
    constexpr int kShift = 16 - kPairBits;
    const auto rounded = [](int32_t q16) { return static_cast<uint32_t>((q16 + (1 << (kShift - 1))) >> kShift); };
    return (rounded(origin_q16) << 16) + rounded(direction_q16);
}

// From one origin's texels to the next one's, and from texel to texel.
struct PairUnits {
    int32_t row_bytes, texel_bytes;
};

// Without kFlips the span has no flipped cells, and nothing is spent on them.
template <bool kFlips>
class PairSource
{
public:
    PairSource(const SpanSide& origins, const SpanSide& directions, const uint8_t* texels, const PairUnits& units)
        : steps_(origins, directions, units.texel_bytes),
          at_{pair_begin(origins.u_q16, directions.u_q16), pair_begin(origins.v_q16, directions.v_q16)},
          step_{pair_step(origins.du_q16, directions.du_q16), pair_step(origins.dv_q16, directions.dv_q16)}
    {
        const int32_t origin = steps_.origin_cell(origins.u_q16, origins.v_q16);
        const int32_t direction = steps_.direction_cell(directions.u_q16, directions.v_q16);
        const int32_t first = (origins.base + origin) * units.row_bytes + directions.base * units.texel_bytes;
        rows_ = {settled(texels + (first + direction)), units.row_bytes};
        across_ = {steps_.across_origin() * units.row_bytes, steps_.across_direction()};
        if (kFlips) {
            origin_flip_ = {{origins.flip - origin, origins.flip_mask}};
            direction_flip_ = {{directions.flip * units.texel_bytes - direction, directions.flip_mask}};
        }
    }

    // Of the next pixel.
    template <class Sum>
    LUMI_ALWAYS_INLINE PairTaps taps()
    {
        using Bits = PairBits<Sum::kRowBits, Sum::kTapBits>;
        const WordPair<uint32_t> at = reload(at_), step = reload(step_);
        at_ = {at.a + step.a, at.b + step.b};
        const uint32_t fu = Bits::fraction(at.a);
        uint32_t fv = Bits::fraction(at.b);
        PairSteps steps = steps_.reloaded();
        int32_t origin = steps.origin(at.a, at.b);
        int32_t direction = steps.direction(at.a, at.b);
        const WordPair<const uint8_t*, int32_t> rows = reload(rows_);
        WordPair<int32_t> across = reload(across_);
        // The same cell in the basis of `first` and -`second` is one of the others.
        if (kFlips && __builtin_expect(origin_flip_.is_flipped(origin), false)) {
            origin += steps.second_origin();
            fv += Bits::kOneOrigin - 2 * (fv & 0xFFFF0000u);
            steps.reflect_origins();
            across.a = steps.across_origin() * rows.b;
        }
        if (kFlips && __builtin_expect(direction_flip_.is_flipped(direction), false)) {
            direction += steps.second_direction();
            fv += Bits::kOneDirection - 2 * (fv & 0xFFFFu);
            steps.reflect_directions();
            across.b = steps.across_direction();
        }
        const PairTriangle t = steps.template triangle<Bits>(fu, fv);
        PairTaps taps;
        taps.row[0] = settled(rows.a + direction) + origin * rows.b;
        taps.row[1] = taps.row[0] + t.middle_origin * rows.b;
        taps.row[2] = taps.row[0] + across.a;
        taps.offset[0] = t.middle_direction;
        taps.offset[1] = across.b;
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k) {
            taps.row_weight[k] = Sum::kUpperHalves ? t.weight[k] : t.weight[k] >> 16;
            taps.weight[k] = Sum::kLowerHalves ? t.weight[k] : t.weight[k] & 0xFFFF;
        }
        return taps;
    }

private:
    PairSteps steps_;
    WordPair<uint32_t> at_, step_;            // u and v
    WordPair<const uint8_t*, int32_t> rows_;  // the texel of (0, 0) on both sides, bytes from one origin to the next
    WordPair<int32_t> across_;                // to the corner across, of the origins' rows and within them, in bytes
    PairFlip origin_flip_, direction_flip_;
};

}  // namespace lumi
