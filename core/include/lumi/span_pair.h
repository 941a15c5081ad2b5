// SPDX-License-Identifier: MIT
// Both sides of a span through the lattice's cells at once: a side in each half of a word, the origins in the upper
// one, the directions in the lower one.
//
// Coordinates count cells from the one in which the span begins, Q12, in 16 bits: pixels may be up to 0.46 cells apart,
// and a span's 15 steps reach less than eight cells. Steps are rounded to Q12, which moves the last pixel by at most
// 0.002 cells: less than a point's index, so that no corner leaves the lattice (SpanChart keeps one to spare).
// Two halves are added as one word: a lower half below zero takes 2^-12 cells from the upper one, on every core.
#pragma once

#include "lumi/span_pair_steps.h"

namespace lumi
{

// Nine taps: rows of three origins, the same three texels of each, weights that sum to Bits::kOnes.
struct PairTaps {
    const uint8_t* row[3];
    int32_t offset[2];  // of the second and third texel
    uint32_t row_weight[3], weight[3];
};

// Whether a side's cell is divided by the difference of its steps.
struct PairFlip {
    int32_t border, mask;
    bool is_flipped(int32_t offset) const { return ((offset - border) ^ mask) < 0; }
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
          stride_(units.row_bytes),
          u_(begin(origins.u_q16, directions.u_q16)),
          v_(begin(origins.v_q16, directions.v_q16)),
          du_(step(origins.du_q16, directions.du_q16)),
          dv_(step(origins.dv_q16, directions.dv_q16))
    {
        const int32_t origin = steps_.origin_cell(origins.u_q16, origins.v_q16);
        const int32_t direction = steps_.direction_cell(directions.u_q16, directions.v_q16);
        base_ = settled(texels + (origins.base + origin) * stride_ + (directions.base * units.texel_bytes + direction));
        across_row_ = steps_.across_origin() * stride_;
        across_ = steps_.across_direction();
        if (kFlips) {
            origin_flip_ = {origins.flip - origin, origins.flip_mask};
            direction_flip_ = {directions.flip * units.texel_bytes - direction, directions.flip_mask};
        }
    }

    template <class Sum>
    LUMI_ALWAYS_INLINE PairTaps taps() const
    {
        using Bits = PairBits<Sum::kRowBits, Sum::kTapBits>;
        const uint32_t fu = Bits::fraction(u_);
        uint32_t fv = Bits::fraction(v_);
        PairSteps steps = steps_;
        int32_t origin = steps.origin(u_, v_);
        int32_t direction = steps.direction(u_, v_);
        int32_t across_row = across_row_, across = across_;
        // The same cell in the basis of `first` and -`second` is one of the others.
        if (kFlips && __builtin_expect(origin_flip_.is_flipped(origin), false)) {
            origin += steps.second_origin();
            fv += Bits::kOneOrigin - 2 * (fv & 0xFFFF0000u);
            steps.reflect_origins();
            across_row = steps.across_origin() * stride_;
        }
        if (kFlips && __builtin_expect(direction_flip_.is_flipped(direction), false)) {
            direction += steps.second_direction();
            fv += Bits::kOneDirection - 2 * (fv & 0xFFFFu);
            steps.reflect_directions();
            across = steps.across_direction();
        }
        const PairTriangle t = steps.template triangle<Bits>(fu, fv);
        PairTaps taps;
        taps.row[0] = base_ + origin * stride_ + direction;
        taps.row[1] = taps.row[0] + t.middle_origin * stride_;
        taps.row[2] = taps.row[0] + across_row;
        taps.offset[0] = t.middle_direction;
        taps.offset[1] = across;
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k) {
            taps.row_weight[k] = Sum::kUpperHalves ? t.weight[k] : t.weight[k] >> 16;
            taps.weight[k] = Sum::kLowerHalves ? t.weight[k] : t.weight[k] & 0xFFFF;
        }
        return taps;
    }

    void advance()
    {
        u_ += du_;
        v_ += dv_;
    }

private:
    static constexpr int kShift = 16 - kPairBits;

    static uint32_t begin(int32_t origin_q16, int32_t direction_q16)
    {
        const auto fraction = [](int32_t q16) {
            return (static_cast<uint32_t>(q16) >> kShift) & ((1u << kPairBits) - 1);
        };
        return (fraction(origin_q16) << 16) + fraction(direction_q16);
    }
    static uint32_t step(int32_t origin_q16, int32_t direction_q16)
    {
        const auto rounded = [](int32_t q16) { return static_cast<uint32_t>((q16 + (1 << (kShift - 1))) >> kShift); };
        return (rounded(origin_q16) << 16) + rounded(direction_q16);
    }

    PairSteps steps_;
    int32_t stride_;
    uint32_t u_, v_, du_, dv_;
    const uint8_t* base_;
    int32_t across_row_, across_;
    PairFlip origin_flip_, direction_flip_;
};

}  // namespace lumi
