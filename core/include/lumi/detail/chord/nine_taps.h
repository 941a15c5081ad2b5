// SPDX-License-Identifier: MIT
// Nine taps of a pixel, three texels of three origins. With Armv7E-M's DSP extension colours are summed by hand: of a
// row's texels the words as they are, modulo 2^32, and the odd bytes; the even ones are what is left. That spares an
// instruction a tap, and the registers that a compiler spends when it loads all nine before it sums them. The same bits
// as Row::add.
#pragma once

#include "lumi/detail/chord/sums.h"
#include "lumi/detail/double_word.h"

namespace lumi
{

// Rows of three origins, the same three texels of each, weights as Sum takes them.
struct PixelTaps {
    const uint8_t* row[3];
    int32_t offset[2];  // of the second and third texel
    uint32_t row_weight[3], weight[3];
};

template <class Sum>
LUMI_ALWAYS_INLINE Sum sum_of_rows(const Field& field, const PixelTaps& taps)
{
    Sum sum;
#pragma GCC unroll 3
    for (int m = 0; m < 3; ++m) {
        const uint8_t* row = Sum::kRowByRow ? settled_in_order(taps.row[m]) : settled(taps.row[m]);
        typename Sum::Row of_row;
        of_row.add(field, row, taps.weight[0]);
        of_row.add(field, row + taps.offset[0], taps.weight[1]);
        of_row.add(field, row + taps.offset[1], taps.weight[2]);
        sum.add(of_row, taps.row_weight[m]);
    }
    return sum;
}

template <class Sum>
struct NineTaps {
    LUMI_ALWAYS_INLINE static Sum sum(const Field& field, const PixelTaps& taps)
    {
        return sum_of_rows<Sum>(field, taps);
    }
};

// Palette8 takes all the registers that there are: define LUMI_KEEP_FRAME_POINTER to compile with one.
#if defined(__ARM_FEATURE_DSP) && defined(__ARM_FEATURE_UNALIGNED) && defined(__OPTIMIZE__) && !defined(__clang__) && \
    !defined(LUMI_KEEP_FRAME_POINTER)
// clang-format off
// A row's odd bytes into `odd`, its even ones into `all`, in halves; `v` is overwritten. FIRST loads into `all`,
// SECOND and THIRD into `v`.
#define LUMI_ROW(FIRST, SECOND, THIRD)     \
    FIRST                                  \
    SECOND                                 \
    "uxtb16 %[odd], %[all], ror #8\n\t"    \
    "mul %[all], %[all], %[w0]\n\t"        \
    "mul %[odd], %[odd], %[w0]\n\t"        \
    "mla %[all], %[v], %[w1], %[all]\n\t"  \
    "uxtb16 %[v], %[v], ror #8\n\t"        \
    "mla %[odd], %[v], %[w1], %[odd]\n\t"  \
    THIRD                                  \
    "mla %[all], %[v], %[w2], %[all]\n\t"  \
    "uxtb16 %[v], %[v], ror #8\n\t"        \
    "mla %[odd], %[v], %[w2], %[odd]\n\t"  \
    "sub %[all], %[all], %[odd], lsl #8\n\t"

// Three of them, ROW(address of the first texel), each times its weight; RB holds red and blue, GREEN's half G green.
// `r` and `b` are row 0's address and weight before; row 2's lie in memory until they are due.
#define LUMI_ROWS(ROW, RB, GREEN, G)                           \
    ROW("r")                                                   \
    "smulbt %[r], %[" RB "], %[b]\n\t"                         \
    "smul" G "t %[g], %[" GREEN "], %[b]\n\t"                  \
    "smultt %[b], %[" RB "], %[b]\n\t"                         \
    ROW("row")                                                 \
    "smlabt %[r], %[" RB "], %[weight], %[r]\n\t"              \
    "smla" G "t %[g], %[" GREEN "], %[weight], %[g]\n\t"       \
    "smlatt %[b], %[" RB "], %[weight], %[b]\n\t"              \
    "ldrd %[row], %[weight], %[last]\n\t"                      \
    ROW("row")                                                 \
    "smlabt %[r], %[" RB "], %[weight], %[r]\n\t"              \
    "smla" G "t %[g], %[" GREEN "], %[weight], %[g]\n\t"       \
    "smlatt %[b], %[" RB "], %[weight], %[b]\n\t"

#define LUMI_ENTRIES(row)                                      \
    LUMI_ROW("ldrb %[all], [%[" row "]]\n\t"                   \
             "ldr %[all], [%[palette], %[all], lsl #2]\n\t",   \
             "ldrb %[v], [%[" row "], %[second]]\n\t"          \
             "ldr %[v], [%[palette], %[v], lsl #2]\n\t",       \
             "ldrb %[v], [%[" row "], %[third]]\n\t"           \
             "ldr %[v], [%[palette], %[v], lsl #2]\n\t")

// From the byte before a texel, so that the even bytes are that one and green.
#define LUMI_WORDS(row)                                        \
    LUMI_ROW("ldr %[all], [%[" row "]]\n\t",                   \
             "ldr %[v], [%[" row "], %[second]]\n\t",          \
             "ldr %[v], [%[" row "], %[third]]\n\t")

#define LUMI_NINE(TEXEL, ROWS, PALETTE)                                                                               \
    template <>                                                                                                       \
    struct NineTaps<TexelSum<TEXEL, false>> {                                                                          \
        LUMI_ALWAYS_INLINE static TexelSum<TEXEL, false> sum([[maybe_unused]] const Field& field,                     \
                                                             const PixelTaps& taps)                                   \
        {                                                                                                             \
            const DoubleWord<const uint8_t*, uint32_t> last = {taps.row[2], taps.row_weight[2]};                      \
            const uint8_t* row = taps.row[1];                                                                         \
            uint32_t weight = taps.row_weight[1];                                                                     \
            uint32_t r = reinterpret_cast<uint32_t>(taps.row[0]), b = taps.row_weight[0];                             \
            uint32_t g, all, odd, v;                                                                                  \
            asm volatile(ROWS                                                                                         \
                : [r] "+&r"(r), [b] "+&r"(b), [g] "=&r"(g), [all] "=&r"(all), [odd] "=&r"(odd), [v] "=&r"(v),         \
                  [row] "+&r"(row), [weight] "+&r"(weight)                                                            \
                : [second] "r"(taps.offset[0]), [third] "r"(taps.offset[1]), [w0] "r"(taps.weight[0]),                \
                  [w1] "r"(taps.weight[1]), [w2] "r"(taps.weight[2]), [last] "m"(last), [palette] PALETTE             \
                : "memory");                                                                                          \
            return {r, g, b, 0};                                                                                      \
        }                                                                                                             \
    }

LUMI_NINE(TexelPalette8, LUMI_ROWS(LUMI_ENTRIES, "all", "odd", "b"), "r"(field.palette));
LUMI_NINE(TexelRgb888, LUMI_ROWS(LUMI_WORDS, "odd", "all", "t"), "i"(0));

#undef LUMI_NINE
#undef LUMI_WORDS
#undef LUMI_ENTRIES
#undef LUMI_ROWS
#undef LUMI_ROW
// clang-format on
#endif

}  // namespace lumi
