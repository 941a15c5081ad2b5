// SPDX-License-Identifier: MIT
// Words as two halves of 16 bits: what Armv7E-M's DSP extension does in one instruction, and portable twins.
#pragma once

#ifdef __ARM_FEATURE_DSP
#include <arm_acle.h>
#endif

#include <stdint.h>

#include "lumi/detail/register_hints.h"

namespace lumi::detail
{

// The bytes 0 and 2 of a word, or 1 and 3, in halves.
LUMI_ALWAYS_INLINE uint32_t even_bytes(uint32_t v)
{
    return v & 0x00FF00FFu;
}
LUMI_ALWAYS_INLINE uint32_t odd_bytes(uint32_t v)
{
#ifdef __ARM_FEATURE_DSP
    uint32_t result;  // by hand: GCC does not fold a rotation into __uxtb16
    asm("uxtb16 %0, %1, ror #8" : "=r"(result) : "r"(v));
    return result;
#else
    return (v >> 8) & 0x00FF00FFu;
#endif
}

// Products of halves below 2^15, added to a sum. add_product16 multiplies the lower halves (of its twin: the words,
// whose upper halves are zero); add_product_low and _high take a's lower or upper half by b's upper one (of their
// twins: by b).
#ifdef __ARM_FEATURE_DSP
inline constexpr bool kHasHalfProducts = true;

LUMI_ALWAYS_INLINE uint32_t add_product16(uint32_t a, uint32_t b, uint32_t sum)
{
    return static_cast<uint32_t>(__smlabb(static_cast<int32_t>(a), static_cast<int32_t>(b), static_cast<int32_t>(sum)));
}
LUMI_ALWAYS_INLINE uint32_t add_product_low(uint32_t a, uint32_t b, uint32_t sum)
{
    return static_cast<uint32_t>(__smlabt(static_cast<int32_t>(a), static_cast<int32_t>(b), static_cast<int32_t>(sum)));
}
LUMI_ALWAYS_INLINE uint32_t add_product_high(uint32_t a, uint32_t b, uint32_t sum)
{
    return static_cast<uint32_t>(__smlatt(static_cast<int32_t>(a), static_cast<int32_t>(b), static_cast<int32_t>(sum)));
}
// By hand: GCC would take the halves of what does not change in a loop apart before it.
LUMI_ALWAYS_INLINE int32_t product_tops(int32_t a, int32_t b)
{
    int32_t result;
    asm("smultt %0, %1, %2" : "=r"(result) : "r"(a), "r"(b));
    return result;
}
LUMI_ALWAYS_INLINE int32_t product_bottoms(int32_t a, int32_t b)
{
    int32_t result;
    asm("smulbb %0, %1, %2" : "=r"(result) : "r"(a), "r"(b));
    return result;
}
#else
inline constexpr bool kHasHalfProducts = false;

LUMI_ALWAYS_INLINE uint32_t add_product16(uint32_t a, uint32_t b, uint32_t sum)
{
    return sum + a * b;
}
LUMI_ALWAYS_INLINE uint32_t add_product_low(uint32_t a, uint32_t b, uint32_t sum)
{
    return sum + (a & 0xFFFF) * b;
}
LUMI_ALWAYS_INLINE uint32_t add_product_high(uint32_t a, uint32_t b, uint32_t sum)
{
    return sum + (a >> 16) * b;
}
#endif

// Signed halves: a's by b's, both products, and added to a sum; the lower halves' product less the upper ones'; a's
// upper half by b's lower one, added to a sum.
#ifdef __ARM_FEATURE_DSP
LUMI_ALWAYS_INLINE int32_t dual_product(int32_t a, int32_t b)
{
    return __smuad(a, b);
}
LUMI_ALWAYS_INLINE int32_t add_dual_product(int32_t a, int32_t b, int32_t sum)
{
    return __smlad(a, b, sum);
}
LUMI_ALWAYS_INLINE int32_t dual_difference(int32_t a, int32_t b)
{
    return __smusd(a, b);
}
LUMI_ALWAYS_INLINE int32_t add_product_top_bottom(int32_t a, int32_t b, int32_t sum)
{
    return __smlatb(a, b, sum);
}
#else
LUMI_ALWAYS_INLINE int32_t add_dual_product(int32_t a, int32_t b, int32_t sum)
{
    const uint32_t low = static_cast<uint32_t>(static_cast<int16_t>(a) * static_cast<int16_t>(b));
    const uint32_t high = static_cast<uint32_t>((a >> 16) * (b >> 16));
    return static_cast<int32_t>(static_cast<uint32_t>(sum) + low + high);
}
LUMI_ALWAYS_INLINE int32_t dual_product(int32_t a, int32_t b)
{
    return add_dual_product(a, b, 0);
}
LUMI_ALWAYS_INLINE int32_t dual_difference(int32_t a, int32_t b)
{
    return static_cast<int16_t>(a) * static_cast<int16_t>(b) - (a >> 16) * (b >> 16);
}
LUMI_ALWAYS_INLINE int32_t add_product_top_bottom(int32_t a, int32_t b, int32_t sum)
{
    const uint32_t product = static_cast<uint32_t>((a >> 16) * static_cast<int16_t>(b));
    return static_cast<int32_t>(static_cast<uint32_t>(sum) + product);
}
#endif

}  // namespace lumi::detail
