// SPDX-License-Identifier: MIT
// 3x3 texels of luma8 on Armv6-M: one word a pixel, y (see taps.inc).
//
// Stack: 56 bytes. Instructions a pixel: 76, and what taps.inc says of new and of flipped cells.
#if defined(__ARM_ARCH_6M__)
#include "taps.inc"

base    .req    lr
sum     .req    r0
spare   .req    r7
rows    .req    r12                     // the sum of the rows so far

        .macro  next_row
        pop     {spare}                 // the step to it
        adds    texel, texel, spare
        .endm

// The sum of a row, times its weight.
        .macro  add_row
        ldrb    sum, [texel]
        muls    sum, weight0, sum
        ldrb    spare, [texel, second]
        muls    spare, weight1, spare
        adds    sum, sum, spare
        ldrb    spare, [texel, third]
        muls    spare, weight2, spare
        adds    sum, sum, spare
        pop     {spare}                 // the row's weight
        muls    sum, spare, sum
        .endm

        .macro  draw_luma8 may_flip
.Lpixel\@:
        next_taps 12, 12, \may_flip
        add_row
        mov     rows, sum
        next_row
        add_row
        add     rows, sum
        next_row
        add_row
        add     sum, rows
        write_sums {sum}
        bne     .Lpixel\@
        .endm

        begin_loops lumi_linear_luma8, .Lplain, 0
        draw_luma8 1
        return 0
.Lplain:
        draw_luma8 0
        return 0
        .size   lumi_linear_luma8, . - lumi_linear_luma8
#endif
