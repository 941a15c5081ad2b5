// SPDX-License-Identifier: MIT
// Integer square root, reciprocal and trigonometry, each a small table and a short series.
//
// Tables are evaluated by the compiler from the formulas in math.cpp: 0.9 KB of flash in all, nothing at run time.
// Roots and quotients begin at one of 192 reciprocal roots and take two Newton steps. Errors stated here are the worst
// over the whole domain, checked in tests/core/math_test.cpp.
#pragma once

#include <stdint.h>

#include "lumi/fixed.h"

namespace lumi::detail
{

// Returns 1/sqrt(v) for v > 0, as mantissa·2^-exponent with mantissa in [2^30, 2^31]. Relative error below 2^-28.
struct ReciprocalRoot {
    uint32_t mantissa;
    int exponent;
};
ReciprocalRoot reciprocal_root(uint64_t v);

// Returns 1/sqrt(m) in Q15 for m in [1/4, 1), by one step in 32-bit products. Relative error below 2^-14.
uint32_t coarse_inverse_root_q15(uint32_t m_q32);

// sqrt(v), rounded down within one unit and 2^-28 of the result; 0 for 0.
uint32_t square_root(uint64_t v);

// The angle of (x, y) from +x towards +y; 0 for (0, 0). |x|, |y| <= 2^30 + 2^10. Error below 2^-27 turn for vectors
// longer than 2^22, growing with the rounding of shorter ones.
uint32_t angle_turns32(int32_t y, int32_t x);

// (a·b) >> shift without losing the high bits of the 96-bit product; rounds down. 0 < shift <= 32; the result must fit.
int64_t multiply_shift(int64_t a, int32_t b, int shift);

// v / kDivisor of numbers up to kMost, in 32 bits: where a product has no more, a compiler calls a library to divide.
template <uint32_t kDivisor, uint32_t kMost>
constexpr uint32_t quotient(uint32_t v)
{
    constexpr int kShift = 16 + 31 - __builtin_clz(kDivisor);
    constexpr uint32_t kFactor = (uint32_t{1} << kShift) / kDivisor + 1;  // at most 2^16 + 1
    static_assert(kMost < 1u << 16, "the product fits");
    static_assert(uint64_t{kMost} * (kFactor * kDivisor - (uint32_t{1} << kShift)) < uint64_t{1} << kShift, "exact");
    return (v * kFactor) >> kShift;
}

}  // namespace lumi::detail
