// SPDX-License-Identifier: MIT
// Words as two halves of 16 bits: what Armv7E-M's DSP extension does in one instruction, and portable twins.
#pragma once

#ifdef __ARM_FEATURE_DSP
#include <arm_acle.h>
#endif

#include <stdint.h>

#include "lumi/detail/compiler.h"

namespace lumi::detail
{

// Returns the bytes 0 and 2 of a word, or 1 and 3, in halves.
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

}  // namespace lumi::detail
