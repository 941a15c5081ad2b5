// SPDX-License-Identifier: MIT
// 3x3 texels of palette8 on Armv6-M: three words a pixel, r, g and b (see taps.inc).
//
// Red and blue of a palette's entry are lanes of one word. The entry's whole word is weighed too, modulo 2^32: without
// the lanes, that sum is 256 times green, and 2^24 times alpha.
//
// Stack: 80 bytes. Instructions a pixel: 167, and what taps.inc says of new and of flipped cells.
#if defined(__ARM_ARCH_6M__)
#include "taps.inc"

        .equ    LANES, 0x00FF00FF
        .equ    OFFSETS_BYTES, 8        // pushed below the rows: `second` and `third`

base    .req    r8
palette .req    r1
entry   .req    r0
lanes   .req    r7
sum     .req    r3                      // the sum of a row's lanes
words   .req    r9                      // the sum of a row's whole words
red     .req    r10                     // sums of the rows so far
green   .req    r11
blue    .req    r12
mask    .req    lr                      // LANES

// Goes on to the next row, whose step lies at [sp, step].
        .macro  next_row step
        ldr     lanes, [sp, #\step]
        adds    texel, texel, lanes
        .endm

// The entry of the index in `entry`, times its weight, and its lanes.
        .macro  weigh lanes, weight
        lsls    entry, entry, #2
        ldr     entry, [palette, entry]
        mov     \lanes, mask
        ands    \lanes, \lanes, entry
        muls    entry, \weight, entry
        muls    \lanes, \weight, \lanes
        .endm

// The sums of a row's three entries, in `entry`, and of their lanes, in `sum`.
        .macro  sum_row
        ldrb    entry, [texel]
        weigh   sum, weight0
        mov     words, entry
        ldr     entry, [sp, #0]
        ldrb    entry, [texel, entry]
        weigh   lanes, weight1
        adds    sum, sum, lanes
        add     words, entry
        ldr     entry, [sp, #4]
        ldrb    entry, [texel, entry]
        weigh   lanes, weight2
        adds    sum, sum, lanes
        add     entry, words
        .endm

// Takes these apart into registers r, g, b, of which r may be `sum`, each times the row's weight at [sp, weight]. `to`
// says what becomes of each and its sum.
        .macro  split_row weight, to, r, g, b
        ldr     lanes, [sp, #\weight]
        subs    \g, entry, sum
        lsls    \g, \g, #8
        lsrs    \g, \g, #16
        muls    \g, lanes, \g
        \to     green, \g
        lsrs    \b, sum, #16
        muls    \b, lanes, \b
        \to     blue, \b
        uxth    \r, sum
        muls    \r, lanes, \r
        \to     red, \r
        .endm

        .macro  draw_palette8 may_flip
        ldr     r0, =LANES
        mov     mask, r0
.Lpixel\@:
        next_taps 7, 7, \may_flip
        push    {second, third}
        ldr     palette, [sp, #(OFFSETS_BYTES + ROWS_BYTES + ARGUMENT_PALETTE)]
        sum_row
        split_row 8, mov, sum, entry, entry
        next_row 12
        sum_row
        split_row 16, add, sum, entry, entry
        next_row 20
        sum_row
        split_row 24, add_to, r3, r4, r5
        add     sp, #(OFFSETS_BYTES + ROWS_BYTES)
        write_sums {r3, r4, r5} // red, green, blue
        beq     .Ldrawn\@
        b       .Lpixel\@
.Ldrawn\@:
        .endm

        begin_loops lumi_linear_palette8, .Lplain, 1
        draw_palette8 1
        return 1
.Lplain:
        draw_palette8 0
        return 1
        .size   lumi_linear_palette8, . - lumi_linear_palette8
#endif
