// SPDX-License-Identifier: MIT
// The taps of one side of a span, pixel by pixel: through the lattice's cells, or over a pole's cap.
//
// A source has base(), the offset of its index 0, taps<bits>() and advance(). Offsets are in bytes, so that the sum of
// both sides' offsets addresses a texel.
#pragma once

#ifdef __ARM_FEATURE_DSP
#include <arm_acle.h>
#endif

#include "lumi/detail/register_hints.h"
#include "lumi/detail/stepping/zones.h"

namespace lumi
{

// Where a side's lattice steps lie in memory.
struct SpanSteps {
    int32_t first, second, base;
    int32_t flip, flip_mask;

    SpanSteps(const SpanSide& side, int32_t stride_bytes)
        : first(side.first * stride_bytes),
          second(side.second * stride_bytes),
          base(side.base * stride_bytes),
          flip(side.flip * stride_bytes),
          flip_mask(side.flip_mask)
    {
    }

    // Offset of a cell's lowest corner from `base`.
    int32_t corner(int32_t u_q16, int32_t v_q16) const { return first * (u_q16 >> 16) + second * (v_q16 >> 16); }
    // Whether the diagonal of the cell at a corner is the difference of both steps.
    bool is_flipped(int32_t corner) const { return ((corner - flip) ^ flip_mask) < 0; }
};

// Where the whole parts of two coordinates lie: their products with a side's steps, counted in `unit` bytes or points.
// Steps are below 378 (F_14) and a texel has at most three bytes, so with Armv7E-M's DSP extension both steps share a
// register and each product takes one instruction (SMULTB, SMLATT); the sums are the same.
class SpanIndex
{
public:
#ifdef __ARM_FEATURE_DSP
    SpanIndex(const SpanSide& side, int32_t unit)
        : steps_((side.first * unit & 0xFFFF) | static_cast<int32_t>(static_cast<uint32_t>(side.second * unit) << 16))
    {
    }

    LUMI_ALWAYS_INLINE int32_t at(int32_t u_q16, int32_t v_q16) const
    {
        return __smlatt(v_q16, steps_, __smlatb(u_q16, steps_, 0));
    }

private:
    int32_t steps_;
#else
    SpanIndex(const SpanSide& side, int32_t unit) : first_(side.first * unit), second_(side.second * unit) {}

    LUMI_ALWAYS_INLINE int32_t at(int32_t u_q16, int32_t v_q16) const
    {
        return first_ * (u_q16 >> 16) + second_ * (v_q16 >> 16);
    }

private:
    int32_t first_, second_;
#endif
};

// Three taps of a side: offsets in memory and weights that sum to 2^kBits.
struct SpanTaps {
    int32_t offset[3];
    uint32_t weight[3];
};

// The taps of a side that runs through the lattice's cells.
class CellSource
{
public:
    CellSource(const SpanSide& side, int32_t stride_bytes)
        : steps_(side, stride_bytes), u_q16_(side.u_q16), v_q16_(side.v_q16), du_q16_(side.du_q16), dv_q16_(side.dv_q16)
    {
    }

    int32_t base() const { return steps_.base; }

    // The triangle of the cell: its halves meet along the sum of both steps. Selected by masks: no branch, no flags.
    template <int kBits>
    LUMI_ALWAYS_INLINE SpanTaps taps() const
    {
        constexpr int32_t kOne = 1 << kBits;
        const int32_t fu = (u_q16_ >> (16 - kBits)) & (kOne - 1);
        const int32_t fv = (v_q16_ >> (16 - kBits)) & (kOne - 1);
        const int32_t corner = steps_.corner(u_q16_, v_q16_);
        if (__builtin_expect(steps_.is_flipped(corner), false)) return flipped(corner, fu, fv, kOne);
        const int32_t difference = fu - fv;
        const int32_t upper = difference >> 31;  // all ones where fu < fv
        const int32_t between = (difference ^ upper) - upper;
        const int32_t less = fv + (difference & upper);
        const int32_t middle = corner + steps_.first + ((steps_.second - steps_.first) & upper);
        return {{corner, middle, corner + steps_.first + steps_.second},
                {static_cast<uint32_t>(kOne - less - between), static_cast<uint32_t>(between),
                 static_cast<uint32_t>(less)}};
    }

    void advance()
    {
        u_q16_ += du_q16_;
        v_q16_ += dv_q16_;
    }

private:
    // The triangle of a cell that the difference of both steps divides.
    SpanTaps flipped(int32_t corner, int32_t fu, int32_t fv, int32_t one) const
    {
        const int32_t over = fu + fv - one;
        const auto weight = [](int32_t w) { return static_cast<uint32_t>(w); };
        const int32_t first = corner + steps_.first;
        const int32_t second = corner + steps_.second;
        if (over < 0) return {{corner, first, second}, {weight(-over), weight(fu), weight(fv)}};
        return {{first + steps_.second, first, second}, {weight(over), weight(one - fv), weight(one - fu)}};
    }

    SpanSteps steps_;
    int32_t u_q16_, v_q16_, du_q16_, dv_q16_;
};

// One tap of a side, pixel by pixel; its offset is relative to base().
template <bool kInCap>
class OneTap;

template <>
class OneTap<false>
{
public:
    OneTap(const SpanSide& side, int32_t stride_bytes)
        : index_(side, 1),
          stride_(stride_bytes),
          base_(side.base * stride_bytes),
          u_q16_(side.u_q16),
          v_q16_(side.v_q16),
          du_q16_(side.du_q16),
          dv_q16_(side.dv_q16)
    {
    }

    int32_t base() const { return base_; }
    // At the coordinates, rounded down after `add` was added to both.
    template <class Offsets>
    int32_t offset(int32_t add_q16) const
    {
        return index_.at(u_q16_ + add_q16, v_q16_ + add_q16) * stride_;
    }
    void advance()
    {
        u_q16_ += du_q16_;
        v_q16_ += dv_q16_;
    }

private:
    SpanIndex index_;
    int32_t stride_, base_;
    int32_t u_q16_, v_q16_, du_q16_, dv_q16_;
};

// Walks a side over a cap pixel by pixel: two weights in registers, the third is what is left of 2^16.
class CapWalk
{
public:
    CapWalk(SpanCap& cap, int32_t step_bytes) : cap_(cap), step_(step_bytes) { take(); }

    int32_t offset(int corner) const { return offset_[corner]; }
    int32_t first_q16() const { return 65536 - second_ - third_; }
    int32_t second_q16() const { return second_; }
    int32_t third_q16() const { return third_; }

    LUMI_ALWAYS_INLINE void advance()
    {
        ++pixel_;
        second_ += step_second_;
        third_ += step_third_;
        if ((second_ | third_ | first_q16()) >= 0) return;
        cap_.find(pixel_);
        take();
    }

private:
    void take()
    {
        for (int k = 0; k < 3; ++k) offset_[k] = cap_.corner[k] * step_;
        second_ = cap_.weight_q16[1];
        third_ = cap_.weight_q16[2];
        step_second_ = cap_.step_q16[1];
        step_third_ = cap_.step_q16[2];
    }

    SpanCap& cap_;
    int32_t step_;
    int32_t second_, third_, step_second_, step_third_;
    int32_t offset_[3];
    int32_t pixel_ = 0;
};

template <>
class OneTap<true>
{
public:
    OneTap(const SpanSide& side, int32_t stride_bytes)
        : walk_(*side.cap, side.first * stride_bytes), base_(side.base * stride_bytes)
    {
    }

    int32_t base() const { return base_; }
    template <class Offsets>
    int32_t offset(int32_t add_q16) const
    {
        return walk_.offset(Offsets::pick(walk_.first_q16(), walk_.second_q16(), walk_.third_q16(), add_q16));
    }
    void advance() { walk_.advance(); }

private:
    CapWalk walk_;
    int32_t base_;
};

// The taps of a side over a cap.
class CapSource
{
public:
    CapSource(const SpanSide& side, int32_t stride_bytes)
        : walk_(*side.cap, side.first * stride_bytes), base_(side.base * stride_bytes)
    {
    }

    int32_t base() const { return base_; }

    template <int kBits>
    LUMI_ALWAYS_INLINE SpanTaps taps() const
    {
        constexpr uint32_t kOne = 1u << kBits;
        constexpr uint32_t kHalf = 1u << (15 - kBits);
        const uint32_t w1 = (static_cast<uint32_t>(walk_.second_q16()) + kHalf) >> (16 - kBits);
        const uint32_t w2 = static_cast<uint32_t>(walk_.third_q16()) >> (16 - kBits);
        return {{walk_.offset(0), walk_.offset(1), walk_.offset(2)}, {w1 + w2 < kOne ? kOne - w1 - w2 : 0, w1, w2}};
    }

    void advance() { walk_.advance(); }

private:
    CapWalk walk_;
    int32_t base_;
};

}  // namespace lumi
