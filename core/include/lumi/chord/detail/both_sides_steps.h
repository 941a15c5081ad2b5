// SPDX-License-Identifier: MIT
// The lattice steps of both sides of a span (see both_sides.h), and what a pixel's coordinates select of them. With
// Armv7E-M's DSP extension both sides share registers and instructions; the results are the same.
#pragma once

#include "lumi/chord/detail/halves.h"
#include "lumi/chord/detail/stepping/lattice_line.h"

namespace lumi::detail
{

// Two words that an inner loop keeps in memory and reads by one instruction where there is one (LDRD of Armv7-M), in
// place of two registers or of two that a compiler spills one by one.
template <class A, class B = A>
struct DoubleWord {
    A a;
    B b;
};

template <class A, class B>
LUMI_ALWAYS_INLINE DoubleWord<A, B> reload(const DoubleWord<A, B>& words)
{
#ifdef __ARM_FEATURE_DSP
    static_assert(sizeof(A) == 4 && sizeof(B) == 4, "LDRD loads words");
    A a;
    B b;
    asm volatile("ldrd %0, %1, %2" : "=r"(a), "=r"(b) : "m"(words));
    return {a, b};
#else
    return words;
#endif
}

inline constexpr int kFractionBits = 12;  // bits of a coordinate's fraction

struct BothSidesTriangle {
    uint32_t weight[3];  // for the lowest corner, the middle one and the one across; in halves
    int32_t middle_origin, middle_direction;
};

// Holds fractions of both sides, of kRowBits of the origins and kTapBits of the directions.
template <int kRowBits, int kTapBits>
struct BothSidesBits {
    static constexpr uint32_t kOneDirection = 1u << kTapBits;
    static constexpr uint32_t kOneOrigin = 0x10000u << kRowBits;
    static constexpr uint32_t kOnes = kOneOrigin | kOneDirection;

    static constexpr uint32_t fraction(uint32_t q12)
    {
        constexpr uint32_t kMask = kOnes - 0x00010001u;
        if (kRowBits == kTapBits) return (q12 >> (kFractionBits - kRowBits)) & kMask;
        return ((q12 >> (kFractionBits - kRowBits)) & (kMask & 0xFFFF0000u)) |
               ((q12 >> (kFractionBits - kTapBits)) & (kMask & 0xFFFFu));
    }
    // Turns halves of one or zero into 1 or 0.
    static constexpr uint32_t whole(uint32_t ones)
    {
        if (kRowBits == kTapBits) return ones >> kRowBits;
        return ((ones >> kRowBits) & 0x10000u) | ((ones & kOneDirection) >> kTapBits);
    }
};

// Steps of both sides: of the origins in points, of the directions in bytes, each below 2^11 (F_14 = 377, three bytes).
#ifdef __ARM_FEATURE_DSP
class BothSidesSteps
{
public:
    BothSidesSteps(const CellLine& origins, const CellLine& directions, int32_t bytes)
        : steps_{pack(origins.first, directions.first * bytes), pack(origins.second, directions.second * bytes)}
    {
    }

    // These stay in registers.
    BothSidesSteps reloaded() const { return BothSidesSteps(reload(steps_)); }

    // Offsets of the cells that hold whole coordinates, in the upper halves of u and v, of one side.
    int32_t origin_cell(int32_t u_q16, int32_t v_q16) const
    {
        return __smlatt(v_q16, steps_.b, (u_q16 >> 16) * (steps_.a >> 16));
    }
    int32_t direction_cell(int32_t u_q16, int32_t v_q16) const
    {
        return __smlatb(v_q16, steps_.b, (u_q16 >> 16) * static_cast<int16_t>(steps_.a));
    }
    // These take the halves of words.
    LUMI_ALWAYS_INLINE int32_t origin(uint32_t u, uint32_t v) const
    {
        return __smlatt(whole(v), steps_.b, product_tops(whole(u), steps_.a)) >> kFractionBits;
    }
    LUMI_ALWAYS_INLINE int32_t direction(uint32_t u, uint32_t v) const
    {
        return __smlabb(whole(v), steps_.b, product_bottoms(whole(u), steps_.a)) >> kFractionBits;
    }

    // Computes CellTriangle (lumi/detail/lattice.h) in both halves at once: weights 1 - max(fu, fv), max - min and min,
    // and the middle corner, `first` on where fu >= fv, else `second` on. Bits::kOnes is 1 in each half. SSUB16 leaves
    // a flag for each half where fu >= fv, by which SEL takes its bytes from one word or the other.
    template <class Bits>
    LUMI_ALWAYS_INLINE BothSidesTriangle triangle(uint32_t fu, uint32_t fv) const
    {
        (void)__ssub16(static_cast<int32_t>(fu), static_cast<int32_t>(fv));  // sets a flag per half where fu >= fv
        const uint32_t less = __sel(fv, fu);
        const uint32_t more = __sel(fu, fv);
        const int32_t middle =
            static_cast<int32_t>(__sel(static_cast<uint32_t>(steps_.a), static_cast<uint32_t>(steps_.b)));
        return {{Bits::kOnes - more, more - less, less}, middle >> 16, static_cast<int16_t>(middle)};
    }

    void reflect_origins() { steps_.b = pack(-second_origin(), second_direction()); }
    void reflect_directions() { steps_.b = pack(second_origin(), -second_direction()); }

    int32_t second_origin() const { return steps_.b >> 16; }
    int32_t second_direction() const { return static_cast<int16_t>(steps_.b); }
    int32_t across_origin() const { return (steps_.a >> 16) + second_origin(); }
    int32_t across_direction() const { return static_cast<int16_t>(steps_.a) + second_direction(); }

private:
    static int32_t pack(int32_t origin, int32_t direction)
    {
        return (direction & 0xFFFF) | static_cast<int32_t>(static_cast<uint32_t>(origin) << 16);
    }
    static int32_t whole(uint32_t q12) { return static_cast<int32_t>(q12 & 0xF000F000u); }

    explicit BothSidesSteps(const DoubleWord<int32_t>& steps) : steps_(steps) {}

    DoubleWord<int32_t> steps_;  // first and second
};
#else
class BothSidesSteps
{
public:
    BothSidesSteps(const CellLine& origins, const CellLine& directions, int32_t bytes)
        : first_origin_(origins.first),
          second_origin_(origins.second),
          first_direction_(directions.first * bytes),
          second_direction_(directions.second * bytes)
    {
    }

    const BothSidesSteps& reloaded() const { return *this; }

    int32_t origin_cell(int32_t u_q16, int32_t v_q16) const
    {
        return first_origin_ * (u_q16 >> 16) + second_origin_ * (v_q16 >> 16);
    }
    int32_t direction_cell(int32_t u_q16, int32_t v_q16) const
    {
        return first_direction_ * (u_q16 >> 16) + second_direction_ * (v_q16 >> 16);
    }
    LUMI_ALWAYS_INLINE int32_t origin(uint32_t u, uint32_t v) const
    {
        constexpr int kShift = 16 + kFractionBits;
        return first_origin_ * (static_cast<int32_t>(u) >> kShift) +
               second_origin_ * (static_cast<int32_t>(v) >> kShift);
    }
    LUMI_ALWAYS_INLINE int32_t direction(uint32_t u, uint32_t v) const
    {
        constexpr int kShift = 16 + kFractionBits;
        return first_direction_ * (static_cast<int32_t>(u << 16) >> kShift) +
               second_direction_ * (static_cast<int32_t>(v << 16) >> kShift);
    }

    // Computes the same without SSUB16: bit kRowBits or kTapBits of fu + 1 - fv is set where fu >= fv. Less one, it is
    // a mask of the half's lower bits, by which min and max come from exchanging the bits in which fu and fv differ.
    template <class Bits>
    LUMI_ALWAYS_INLINE BothSidesTriangle triangle(uint32_t fu, uint32_t fv) const
    {
        const uint32_t ones = ((fu | Bits::kOnes) - fv) & Bits::kOnes;
        const uint32_t lower = Bits::whole(ones);  // fu >= fv
        const uint32_t mask = ones - lower;
        const uint32_t swap = (fu ^ fv) & mask;
        const uint32_t less = fu ^ swap;
        const uint32_t more = fv ^ swap;
        const auto chosen = [](int32_t first, int32_t second, uint32_t is_first) {
            return second + ((first - second) & -static_cast<int32_t>(is_first));
        };
        return {{Bits::kOnes - more, more - less, less},
                chosen(first_origin_, second_origin_, lower >> 16),
                chosen(first_direction_, second_direction_, lower & 1)};
    }

    void reflect_origins() { second_origin_ = -second_origin_; }
    void reflect_directions() { second_direction_ = -second_direction_; }

    int32_t second_origin() const { return second_origin_; }
    int32_t second_direction() const { return second_direction_; }
    int32_t across_origin() const { return first_origin_ + second_origin_; }
    int32_t across_direction() const { return first_direction_ + second_direction_; }

private:
    int32_t first_origin_, second_origin_, first_direction_, second_direction_;
};
#endif

}  // namespace lumi::detail
