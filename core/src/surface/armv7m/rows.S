// SPDX-License-Identifier: MIT
// Rows of 5-6-5 pixels on Armv7-M and later, with Thumb-2: what draw_rows (surface/row_loops.h) does, for the nearest
// texel or two taps.
//
// Instructions: a row about 34, a sample that is written 31 (two taps) or 23, one that is not 7.
#if defined(__thumb2__) && __ARM_ARCH_PROFILE == 'M'
#include "../rows.inc"

// On the stack, below the registers that are kept.
        .equ    GUARD_AT, 0
        .equ    FIELDS_AT, 4
        .equ    COLOURS, 8
        .equ    STATE, 12
        .equ    FRAME_BYTES, 20

depth_at        .req    r0
depth_end       .req    r1
depth           .req    r2
place           .req    r3
colour          .req    r4
depth_right     .req    r5
place_right     .req    r6
colour_right    .req    r7
texels          .req    r8
columns         .req    r9
palette         .req    r10

// The palette's entry of the texel at `place`, into `entry`.
        .macro  tap entry, place
        ubfx    lr, \place, #10, #6
        lsr     \entry, \place, #26
        mla     \entry, \entry, columns, texels
        ldrb    \entry, [\entry, lr]
        ldr     \entry, [palette, \entry, lsl #2]
        .endm

        .macro  rows_loop name, taps, swaps
        hot_function \name
        push    {r4-r11, lr}
        sub     sp, #FRAME_BYTES
        ldr     r2, =GUARD_BITS
        ldr     r3, =FIELDS
        ldr     r4, [r0, #COLOURS_AT]
        strd    r2, r3, [sp, #GUARD_AT]
        subs    r4, #2                  // depth_at is one further when a colour is stored
        strd    r4, r0, [sp, #COLOURS]
        add     r1, r0, #RIGHT
        ldm     r1, {depth_right, place_right, colour_right}
        add     r1, r0, #TEXELS
        ldm     r1, {texels, columns, palette}
.Lrow_\name:
        mov     lr, r0
        ldm     lr, {r0, r1, r2, r3, r4, r11, r12}  // edges, steps, depth, place, colour
        add     r2, r0
        add     r3, r1
        strd    r2, r3, [lr, #EDGES]
        asr     r0, r0, #16
        asr     r1, r1, #16
        cmp     r0, r1
        bge     .Lnext_row_\name
        ldr     lr, [lr, #ROW]
        mla     depth, depth_right, r0, r4
        mla     place, place_right, r0, r11
        mla     colour, colour_right, r0, r12
        add     depth_at, lr, r0, lsl #1
        add     depth_end, lr, r1, lsl #1
.Lsample_\name:
        ldrh    r12, [depth_at], #2
        cmp     r12, depth, lsr #16
        bhs     .Lhidden_\name
        lsr     r12, depth, #16
        strh    r12, [depth_at, #-2]
        tap     r12, place
        .if     \taps == 2
        add     r11, place, #(TAPS_APART << 16)
        add     r11, r11, #TAPS_APART
        tap     r11, r11
        add     r12, r12, r11
        .endif
        ldrd    r11, lr, [sp, #GUARD_AT]
        add     r12, r12, colour
        tst     r12, r11
        bne     .Lclamp_\name
.Lclamped_\name:
        ldr     r11, [sp, #COLOURS]
        and     r12, lr, r12, lsr #4
        orr     r12, r12, r12, lsr #16
        .if     \swaps
        rev16   r12, r12
        .endif
        strh    r12, [depth_at, r11]
.Lhidden_\name:
        add     depth, depth_right
        add     place, place_right
        add     colour, colour_right
        cmp     depth_at, depth_end
        bne     .Lsample_\name
.Lnext_row_\name:
        ldr     r0, [sp, #STATE]
        add     lr, r0, #QUANTITIES
        ldm     lr, {r1, r2, r3}
        add     r12, r0, #DOWN
        ldm     r12, {r4, r11, r12, lr}             // down, row
        add     r1, r4
        add     r2, r11
        add     r3, r12
        ldr     r4, [r0, #ROW_BYTES]
        add     r12, r0, #QUANTITIES
        stm     r12, {r1, r2, r3}
        add     lr, r4
        str     lr, [r0, #ROW]
        ldrd    r1, r2, [r0, #COUNT]                // and those below
        subs    r1, #1
        str     r1, [r0, #COUNT]
        bne     .Lrow_\name
        cbz     r2, .Lend_\name
        strd    r2, r1, [r0, #COUNT]
        add     r1, r0, #BENT_EDGE
        ldm     r1, {r1, r2, r3}
        add     r1, r0, r1, lsl #2
        str     r2, [r1, #EDGES]
        str     r3, [r1, #STEPS]
        b       .Lrow_\name
.Lend_\name:
        add     sp, #FRAME_BYTES
        pop     {r4-r11, pc}
.Lclamp_\name:
        push    {r0-r3}
        mov     r0, r12
        bl      lumi_clamped
        mov     r12, r0
        pop     {r0-r3}
        ldr     lr, [sp, #FIELDS_AT]
        b       .Lclamped_\name
        .pool
        .size   \name, . - \name
        .endm

        every_rows_loop
#endif
