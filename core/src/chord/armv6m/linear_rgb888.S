// SPDX-License-Identifier: MIT
// 3x3 texels of RGB888 on Armv6-M: three words a pixel, r, g and b (see taps.inc).
//
// Stack: 72 bytes. Instructions a pixel: 152, and what taps.inc says of new and of flipped cells.
#if defined(__ARM_ARCH_6M__)
#include "taps.inc"

base    .req    r8
texel1  .req    second                  // addresses of the second and third texel
texel2  .req    third
sum     .req    r0
spare   .req    r7
red     .req    r9                      // sums of the rows so far
green   .req    r10
blue    .req    r11

// Goes on to the next row, whose step lies at [sp, step].
        .macro  next_row step
        ldr     spare, [sp, #\step]
        adds    texel, texel, spare
        adds    texel1, texel1, spare
        adds    texel2, texel2, spare
        .endm

// The channel at `byte` of a row's texels, times the row's weight at [sp, weight].
        .macro  sum_channel byte, weight
        ldrb    sum, [texel, #\byte]
        muls    sum, weight0, sum
        ldrb    spare, [texel1, #\byte]
        muls    spare, weight1, spare
        adds    sum, sum, spare
        ldrb    spare, [texel2, #\byte]
        muls    spare, weight2, spare
        adds    sum, sum, spare
        ldr     spare, [sp, #\weight]
        muls    sum, spare, sum
        .endm

// A row, times its weight. `to` says what becomes of red, which comes last, and `others` of the other sums.
        .macro  sum_row weight, others, to
        sum_channel 2, \weight
        \others blue, sum
        sum_channel 1, \weight
        \others green, sum
        sum_channel 0, \weight
        \to     red, sum
        .endm

        .macro  draw_rgb888 may_flip
.Lpixel\@:
        next_taps 7, 7, \may_flip
        adds    texel1, texel1, texel
        adds    texel2, texel2, texel
        sum_row 0, mov, mov
        next_row 4
        sum_row 8, add, add
        next_row 12
        sum_row 16, add, add_to
        add     sp, #ROWS_BYTES
        mov     r3, green
        mov     r4, blue
        write_sums {sum, r3, r4} // red, green, blue
        beq     .Ldrawn\@
        b       .Lpixel\@
.Ldrawn\@:
        .endm

        begin_loops lumi_linear_rgb888, .Lplain, 1
        draw_rgb888 1
        return 1
.Lplain:
        draw_rgb888 0
        return 1
        .size   lumi_linear_rgb888, . - lumi_linear_rgb888
#endif
