// SPDX-License-Identifier: MIT
// 3x3 texels of RGB565 on Armv6-M: three words a pixel, r, g and b (see taps.inc).
//
// Three channels share a word: blue at bit 0, red at bit 11, green at bit 21, each with room for 5 bits of weight.
//
// Stack: 72 bytes. Instructions a pixel: 148, and what taps.inc says of new and of flipped cells.
#if defined(__ARM_ARCH_6M__)
#include "taps.inc"

        .equ    FIELDS, 0x07E0F81F

base    .req    r8
fields  .req    r0
spare   .req    r7
sum     .req    r3                      // the sum of a row
kept    .req    r9                      // `third`
red     .req    r10                     // sums of the rows so far
green   .req    r11
blue    .req    r12
mask    .req    lr                      // FIELDS

// Goes on to the next row, whose step lies at [sp, step].
        .macro  next_row step
        ldr     spare, [sp, #\step]
        adds    texel, texel, spare
        .endm

// The texel in `fields`, its channels apart, times its weight.
        .macro  weigh weight
        lsls    spare, fields, #16
        orrs    fields, fields, spare
        mov     spare, mask
        ands    fields, fields, spare
        muls    fields, \weight, fields
        .endm

// The sum of a row's three texels, in `fields`.
        .macro  sum_row
        ldrh    fields, [texel]
        weigh   weight0
        movs    sum, fields
        ldrh    fields, [texel, second]
        weigh   weight1
        adds    sum, sum, fields
        mov     fields, kept
        ldrh    fields, [texel, fields]
        weigh   weight2
        adds    fields, fields, sum
        .endm

// Takes `fields` apart into registers r, g, b, of which r may be `fields`, each times the row's weight at [sp, weight].
// `to` says what becomes of each and its sum.
        .macro  split_row weight, to, r, g, b
        ldr     spare, [sp, #\weight]
        lsrs    \g, fields, #21
        muls    \g, spare, \g
        \to     green, \g
        lsls    \b, fields, #21
        lsrs    \b, \b, #21
        muls    \b, spare, \b
        \to     blue, \b
        lsls    \r, fields, #11
        lsrs    \r, \r, #22
        muls    \r, spare, \r
        \to     red, \r
        .endm

        .macro  draw_rgb565 may_flip
        ldr     r0, =FIELDS
        mov     mask, r0
.Lpixel\@:
        next_taps 8, 5, \may_flip
        mov     kept, third
        sum_row
        split_row 0, mov, fields, sum, sum
        next_row 4
        sum_row
        split_row 8, add, fields, sum, sum
        next_row 12
        sum_row
        split_row 16, add_to, r3, r4, r5
        add     sp, #ROWS_BYTES
        write_sums {r3, r4, r5} // red, green, blue
        beq     .Ldrawn\@
        b       .Lpixel\@
.Ldrawn\@:
        .endm

        begin_loops lumi_linear_rgb565, .Lplain, 1
        draw_rgb565 1
        return 1
.Lplain:
        draw_rgb565 0
        return 1
        .size   lumi_linear_rgb565, . - lumi_linear_rgb565
#endif
