// SPDX-License-Identifier: MIT
// Sums of nine texels in Armv6-M code: one asm statement from a pixel's coordinates (span_pair_thumb.h) to its sum. The
// same bits as PairSource and SpanSum.
#pragma once

#include "lumi/detail/chord/pairs_armv6m.h"

#ifdef LUMI_HAS_THUMB_PAIRS
namespace lumi
{

// clang-format off
// Three greys, times their weights and the row's one.
#define LUMI_THUMB_ROW_LUMA8      \
    LUMI_THUMB(ldrb r0, [r6])     \
    LUMI_THUMB(muls r0, r4, r0)   \
    LUMI_THUMB(ldrb r7, [r6, r2]) \
    LUMI_THUMB(muls r7, r3, r7)   \
    LUMI_THUMB(adds r0, r0, r7)   \
    LUMI_THUMB(ldrb r7, [r6, r1]) \
    LUMI_THUMB(muls r7, r5, r7)   \
    LUMI_THUMB(adds r0, r0, r7)   \
    LUMI_THUMB(pop {r7})          \
    LUMI_THUMB(muls r0, r7, r0)

#define LUMI_THUMB_LUMA8         \
    LUMI_THUMB_ROW_LUMA8         \
    LUMI_THUMB(pop {r7})         \
    LUMI_THUMB(adds r6, r6, r7)  \
    LUMI_THUMB(mov r12, r0)      \
    LUMI_THUMB_ROW_LUMA8         \
    LUMI_THUMB(pop {r7})         \
    LUMI_THUMB(adds r6, r6, r7)  \
    LUMI_THUMB(add r12, r12, r0) \
    LUMI_THUMB_ROW_LUMA8         \
    LUMI_THUMB(add r0, r0, r12)   \
    LUMI_THUMB(add r0, r0, %[half])

// One channel of a row of three RGB888 texels at r6, r2 and r1, moved or added `to` its sum.
#define LUMI_THUMB_CHANNEL(weight, at, to, sum) \
    LUMI_THUMB(ldrb r0, [r6, at])               \
    LUMI_THUMB(muls r0, r4, r0)                 \
    LUMI_THUMB(ldrb r7, [r2, at])               \
    LUMI_THUMB(muls r7, r3, r7)                 \
    LUMI_THUMB(adds r0, r0, r7)                 \
    LUMI_THUMB(ldrb r7, [r1, at])               \
    LUMI_THUMB(muls r7, r5, r7)                 \
    LUMI_THUMB(adds r0, r0, r7)                 \
    LUMI_THUMB(ldr r7, [sp, weight])            \
    LUMI_THUMB(muls r0, r7, r0)                 \
    LUMI_THUMB(to sum, r0)

#define LUMI_THUMB_ROW_RGB888(weight, to)   \
    LUMI_THUMB_CHANNEL(weight, 0, to, %[r]) \
    LUMI_THUMB_CHANNEL(weight, 1, to, %[g]) \
    LUMI_THUMB_CHANNEL(weight, 2, to, %[b])

#define LUMI_THUMB_NEXT_RGB888(step) \
    LUMI_THUMB(ldr r7, [sp, step])   \
    LUMI_THUMB(adds r6, r6, r7)      \
    LUMI_THUMB(adds r2, r2, r7)      \
    LUMI_THUMB(adds r1, r1, r7)

#define LUMI_THUMB_RGB888          \
    LUMI_THUMB(adds r2, r2, r6)    \
    LUMI_THUMB(adds r1, r1, r6)    \
    LUMI_THUMB_ROW_RGB888(0, mov)  \
    LUMI_THUMB_NEXT_RGB888(4)      \
    LUMI_THUMB_ROW_RGB888(8, add)  \
    LUMI_THUMB_NEXT_RGB888(12)     \
    LUMI_THUMB_ROW_RGB888(16, add) \
    LUMI_THUMB(add sp, 20)

// The palette entry of the index in r0, times a weight: r0 of all its bytes, `lanes` of red and blue.
#define LUMI_THUMB_ENTRY(weight, lanes)   \
    LUMI_THUMB(lsls r0, r0, 2)            \
    LUMI_THUMB(ldr r0, [r2, r0])          \
    LUMI_THUMB(mov lanes, %[mask])        \
    LUMI_THUMB(ands lanes, r0)            \
    LUMI_THUMB(muls r0, weight, r0)       \
    LUMI_THUMB(muls lanes, weight, lanes)

// Sums of all bytes less those of red and blue are 256 times green, and 2^24 times alpha.
#define LUMI_THUMB_ROW_PALETTE8(weight, to) \
    LUMI_THUMB(ldrb r0, [r6])               \
    LUMI_THUMB_ENTRY(r4, r1)                \
    LUMI_THUMB(mov %[bytes], r0)            \
    LUMI_THUMB(ldr r0, [sp, 4])             \
    LUMI_THUMB(ldrb r0, [r6, r0])           \
    LUMI_THUMB_ENTRY(r3, r7)                \
    LUMI_THUMB(adds r1, r1, r7)             \
    LUMI_THUMB(add %[bytes], r0)            \
    LUMI_THUMB(ldr r0, [sp])                \
    LUMI_THUMB(ldrb r0, [r6, r0])           \
    LUMI_THUMB_ENTRY(r5, r7)                \
    LUMI_THUMB(adds r1, r1, r7)             \
    LUMI_THUMB(add r0, %[bytes])            \
    LUMI_THUMB(subs r0, r0, r1)             \
    LUMI_THUMB(lsls r0, r0, 8)              \
    LUMI_THUMB(lsrs r0, r0, 16)             \
    LUMI_THUMB(ldr r7, [sp, weight])        \
    LUMI_THUMB(muls r0, r7, r0)             \
    LUMI_THUMB(to %[g], r0)                 \
    LUMI_THUMB(lsrs r0, r1, 16)             \
    LUMI_THUMB(muls r0, r7, r0)             \
    LUMI_THUMB(to %[b], r0)                 \
    LUMI_THUMB(uxth r1, r1)                 \
    LUMI_THUMB(muls r1, r7, r1)             \
    LUMI_THUMB(to %[r], r1)

#define LUMI_THUMB_NEXT_ROW(step) \
    LUMI_THUMB(ldr r7, [sp, step])     \
    LUMI_THUMB(adds r6, r6, r7)

// Pushed are the offsets of the third and second texel, the rows, and the palette's address.
#define LUMI_THUMB_PALETTE8          \
    LUMI_THUMB(push {r1, r2})        \
    LUMI_THUMB(ldr r2, [sp, 28])     \
    LUMI_THUMB_ROW_PALETTE8(8, mov)  \
    LUMI_THUMB_NEXT_ROW(12)     \
    LUMI_THUMB_ROW_PALETTE8(16, add) \
    LUMI_THUMB_NEXT_ROW(20)     \
    LUMI_THUMB_ROW_PALETTE8(24, add) \
    LUMI_THUMB(add sp, 32)

#define LUMI_THUMB_PUSH_PALETTE \
    LUMI_THUMB(ldmia r0!, {r1}) \
    LUMI_THUMB(push {r1})
// The RGB565 texel in r0, its channels apart, times a weight.
#define LUMI_THUMB_FIELDS(weight)   \
    LUMI_THUMB(lsls r7, r0, 16)     \
    LUMI_THUMB(orrs r0, r0, r7)     \
    LUMI_THUMB(mov r7, %[mask])     \
    LUMI_THUMB(ands r0, r0, r7)     \
    LUMI_THUMB(muls r0, weight, r0)

#define LUMI_THUMB_ROW_RGB565(weight, to) \
    LUMI_THUMB(ldrh r0, [r6])             \
    LUMI_THUMB_FIELDS(r4)                 \
    LUMI_THUMB(movs r1, r0)               \
    LUMI_THUMB(ldrh r0, [r6, r2])         \
    LUMI_THUMB_FIELDS(r3)                 \
    LUMI_THUMB(adds r1, r1, r0)           \
    LUMI_THUMB(ldr r0, [sp])              \
    LUMI_THUMB(ldrh r0, [r6, r0])         \
    LUMI_THUMB_FIELDS(r5)                 \
    LUMI_THUMB(adds r0, r0, r1)           \
    LUMI_THUMB(ldr r7, [sp, weight])      \
    LUMI_THUMB(lsrs r1, r0, 21)           \
    LUMI_THUMB(muls r1, r7, r1)           \
    LUMI_THUMB(to %[g], r1)               \
    LUMI_THUMB(lsls r1, r0, 21)           \
    LUMI_THUMB(lsrs r1, r1, 21)           \
    LUMI_THUMB(muls r1, r7, r1)           \
    LUMI_THUMB(to %[b], r1)               \
    LUMI_THUMB(lsls r0, r0, 11)           \
    LUMI_THUMB(lsrs r0, r0, 22)           \
    LUMI_THUMB(muls r0, r7, r0)           \
    LUMI_THUMB(to %[r], r0)

// Pushed are the offset of the third texel and the rows.
#define LUMI_THUMB_RGB565          \
    LUMI_THUMB(push {r1})          \
    LUMI_THUMB_ROW_RGB565(4, mov)  \
    LUMI_THUMB_NEXT_ROW(8)    \
    LUMI_THUMB_ROW_RGB565(12, add) \
    LUMI_THUMB_NEXT_ROW(16)   \
    LUMI_THUMB_ROW_RGB565(20, add) \
    LUMI_THUMB(add sp, 24)
// clang-format on

// What all statements read and spoil. All low registers are spoken for, so it is r0 that holds the state.
#define LUMI_THUMB_BEGIN LUMI_THUMB(.syntax unified)
#define LUMI_THUMB_BITS                                                                                      \
    [row_shift] "n"(32 - Sum::kRowBits), [tap_shift] "n"(32 - Sum::kTapBits), [row_bits] "n"(Sum::kRowBits), \
        [tap_bits] "n"(Sum::kTapBits)
#define LUMI_THUMB_CLOBBERS "r1", "r2", "r3", "r4", "r5", "r6", "r7", "cc", "memory"

// A pixel's statement, with flipped cells or without; `before` and `sum` around what names the taps.
#define LUMI_THUMB_ASM(before, sum, ...)                                                    \
    if constexpr (kFlips) {                                                                 \
        asm volatile(LUMI_THUMB_BEGIN before LUMI_THUMB_TAPS_OR_FLIPPED sum : __VA_ARGS__); \
    } else {                                                                                \
        asm volatile(LUMI_THUMB_BEGIN before LUMI_THUMB_TAPS sum : __VA_ARGS__);            \
    }

template <>
inline constexpr bool kHasThumbPairs<SpanSum<TexelLuma8, false>> = true;
template <>
struct ThumbSum<SpanSum<TexelLuma8, false>> {
    using Sum = SpanSum<TexelLuma8, false>;
    static constexpr uint32_t kHalf = 1u << 23;  // what Sum::store adds, at no cost while a register holds it

    template <bool kFlips>
    LUMI_ALWAYS_INLINE static Sum of(ThumbState<kFlips>& state)
    {
        Sum sum;
        void* at = &state.origins;
        LUMI_THUMB_ASM("", LUMI_THUMB_LUMA8, "+l"(at)
                       : LUMI_THUMB_BITS, [half] "h"(kHalf)
                       : LUMI_THUMB_CLOBBERS, "r12");
        sum.y = reinterpret_cast<uint32_t>(at) - kHalf;
        return sum;
    }
};

template <>
inline constexpr bool kHasThumbPairs<SpanSum<TexelRgb888, false>> = true;
template <>
struct ThumbSum<SpanSum<TexelRgb888, false>> {
    using Sum = SpanSum<TexelRgb888, false>;

    template <bool kFlips>
    LUMI_ALWAYS_INLINE static Sum of(ThumbState<kFlips>& state)
    {
        Sum sum;
        void* at = &state.origins;
        LUMI_THUMB_ASM("", LUMI_THUMB_RGB888, "+l"(at), [r] "=&h"(sum.r), [g] "=&h"(sum.g), [b] "=&h"(sum.b)
                       : LUMI_THUMB_BITS
                       : LUMI_THUMB_CLOBBERS);
        return sum;
    }
};

template <>
inline constexpr bool kHasThumbPairs<SpanSum<TexelRgb565, false>> = true;
template <>
struct ThumbSum<SpanSum<TexelRgb565, false>> {
    using Sum = SpanSum<TexelRgb565, false>;

    template <bool kFlips>
    LUMI_ALWAYS_INLINE static Sum of(ThumbState<kFlips>& state)
    {
        Sum sum;
        void* at = &state.origins;
        LUMI_THUMB_ASM("", LUMI_THUMB_RGB565, "+l"(at), [r] "=&h"(sum.r), [g] "=&h"(sum.g), [b] "=&h"(sum.b)
                       : LUMI_THUMB_BITS, [mask] "h"(Sum::kFields)
                       : LUMI_THUMB_CLOBBERS);
        return sum;
    }
};

template <>
inline constexpr bool kHasThumbPairs<SpanSum<TexelPalette8, false>> = true;
template <>
struct ThumbSum<SpanSum<TexelPalette8, false>> {
    using Sum = SpanSum<TexelPalette8, false>;

    template <bool kFlips>
    LUMI_ALWAYS_INLINE static Sum of(ThumbState<kFlips>& state)
    {
        Sum sum;
        void* at = &state.palette;
        uint32_t bytes;
        LUMI_THUMB_ASM(LUMI_THUMB_PUSH_PALETTE, LUMI_THUMB_PALETTE8,
                       "+l"(at), [r] "=&h"(sum.r), [g] "=&h"(sum.g), [b] "=&h"(sum.b), [bytes] "=&h"(bytes)
                       : LUMI_THUMB_BITS, [mask] "h"(0x00FF00FFu)
                       : LUMI_THUMB_CLOBBERS);
        return sum;
    }
};

}  // namespace lumi
#endif
