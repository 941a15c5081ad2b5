// SPDX-License-Identifier: MIT
// Reciprocals take a table of 768 bytes and one Newton step, in 32-bit products.
#pragma once

#include <stdint.h>

namespace lumi::detail
{

struct ReciprocalTable {
    uint16_t q29[384];  // 2^29/v at the middle of v in [256 k, 256 (k + 1)), k = 128 .. 511
};
extern const ReciprocalTable kReciprocals;

// Returns 2^29/v to 2^-7 for v in [2^15, 2^17).
inline uint32_t coarse_q29(uint32_t v)
{
    return kReciprocals.q29[(v >> 8) - 128];
}

// mantissa · 2^(leading - 47) = 1/v to 2^-16, for v > 0; mantissa in [2^15, 2^16). One Newton step for y = 1/m from the
// table's y0: y = y0 + y0·(1 - m·y0), m being v shifted left until its top bit is set.
struct Reciprocal {
    uint32_t mantissa;
    int32_t leading;  // zeros of v
};

// A number shifted left until its top bit is set, and how far; v > 0.
struct Normalized {
    uint32_t v;
    int32_t leading;
};
inline Normalized normalized(uint32_t v)
{
#if defined(__arm__) && !defined(__ARM_FEATURE_CLZ)
    int32_t leading = 0;  // in line, where the compiler would call a library
#pragma GCC unroll 5
    for (int32_t step = 16; step != 0; step >>= 1) {
        if (v >> (32 - step) != 0) continue;
        v <<= step;
        leading += step;
    }
#else
    const int32_t leading = __builtin_clz(v);
    v <<= leading;
#endif
    return {v, leading};
}

inline Reciprocal reciprocal(uint32_t v)
{
    const Normalized n = normalized(v);
    const int32_t leading = n.leading;
    const uint32_t v17 = n.v >> 15;
    const uint32_t coarse = coarse_q29(v17);
    const uint32_t rest_q29 = (uint32_t{1} << 29) - v17 * coarse;
    return {(coarse << 3) +
                static_cast<uint32_t>(static_cast<int32_t>(coarse) * (static_cast<int32_t>(rest_q29) >> 10) >> 16),
            leading};
}

// (a · m)/2^16 for |a| < 2^31, mantissa m < 2^16; rounds down. With a = 2^16·h + l that is h·m + l·m/2^16, two products
// of 32 bits.
inline int32_t times_q16(int32_t a, uint32_t mantissa)
{
    const int32_t high = a >> 16;
    const uint32_t low = static_cast<uint32_t>(a) & 0xFFFF;
    return high * static_cast<int32_t>(mantissa) + static_cast<int32_t>((low * mantissa) >> 16);
}

// Sums that wrap on the way and are in range at the end.
inline int32_t wrapped_sum(int32_t a, int32_t b)
{
    return static_cast<int32_t>(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
}
inline int32_t wrapped_product(int32_t a, int32_t b)
{
    return static_cast<int32_t>(static_cast<uint32_t>(a) * static_cast<uint32_t>(b));
}

}  // namespace lumi::detail
