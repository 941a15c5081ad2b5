// SPDX-License-Identifier: MIT
// Rows of 5-6-5 pixels on Armv6-M: what draw_rows (surface/row_loops.h) does, for the nearest texel or two taps.
//
// Instructions: a row about 52, a sample that is written 46 (two taps) or 33, one that is not 8.
#if defined(__ARM_ARCH_6M__)
#include "../rows.inc"

// On the stack, below the registers that are kept.
        .equ    GUARD_AT, 0
        .equ    FIELDS_AT, 4
        .equ    APART_AT, 8
        .equ    COLOURS, 12
        .equ    COLUMNS, 16
        .equ    STATE, 20
        .equ    FRAME_BYTES, 28

depth_at        .req    r0
depth           .req    r1
place           .req    r2
colour          .req    r3
depth_right     .req    r8
place_right     .req    r9
colour_right    .req    r10
texels          .req    r11
palette         .req    r12
depth_end       .req    lr

// The palette's entry of the texel at `place`, into `entry`. `columns` and `spare` are low registers.
        .macro  tap entry, place, columns, spare
        lsrs    \entry, \place, #26
        muls    \entry, \columns, \entry
        lsls    \spare, \place, #16
        lsrs    \spare, \spare, #26
        adds    \entry, \entry, \spare
        add     \entry, texels
        ldrb    \entry, [\entry]
        lsls    \entry, \entry, #2
        add     \entry, palette
        ldr     \entry, [\entry]
        .endm

        .macro  rows_loop name, taps, swaps
        hot_function \name
        push    {r4-r7, lr}
        mov     r4, r8
        mov     r5, r9
        mov     r6, r10
        mov     r7, r11
        push    {r4-r7}
        sub     sp, #FRAME_BYTES
        ldr     r4, =GUARD_BITS
        ldr     r5, =FIELDS
        ldr     r6, =TAPS_APART << 16 | TAPS_APART
        ldr     r7, [r0, #COLOURS_AT]
        mov     r3, sp
        stm     r3!, {r4-r7}
        movs    r2, r0
        adds    r2, #RIGHT
        ldm     r2!, {r4-r6}
        mov     depth_right, r4
        mov     place_right, r5
        mov     colour_right, r6
        adds    r2, #(TEXELS - DOWN)
        ldm     r2!, {r4-r6}
        mov     texels, r4
        mov     palette, r6
        str     r5, [sp, #COLUMNS]
        str     r0, [sp, #STATE]
.Lrow_\name:
        movs    r7, r0
        ldm     r7!, {r0-r6}            // edges, steps, depth, place, colour
        adds    r2, r2, r0
        adds    r3, r3, r1
        subs    r7, #RIGHT
        stm     r7!, {r2, r3}
        asrs    r0, r0, #16
        asrs    r1, r1, #16
        cmp     r0, r1
        bge     .Lnext_row_\name
        ldr     r7, [r7, #(ROW - STEPS)]
        lsls    r1, r1, #1
        adds    r1, r1, r7
        mov     depth_end, r1
        mov     r1, depth_right
        muls    r1, r0, r1
        adds    depth, r1, r4
        mov     r2, place_right
        muls    r2, r0, r2
        adds    place, r2, r5
        mov     r3, colour_right
        muls    r3, r0, r3
        adds    colour, r3, r6
        lsls    r0, r0, #1
        adds    depth_at, r0, r7
.Lsample_\name:
        lsrs    r4, depth, #16
        ldrh    r5, [depth_at]
        cmp     r4, r5
        bls     .Lhidden_\name
        strh    r4, [depth_at]
        ldr     r7, [sp, #COLUMNS]
        tap     r4, place, r7, r5
        adds    r4, r4, colour
        .if     \taps == 2
        ldr     r6, [sp, #APART_AT]
        adds    r6, r6, place
        tap     r5, r6, r7, r6
        adds    r4, r4, r5
        .endif
        ldr     r5, [sp, #GUARD_AT]
        tst     r4, r5
        bne     .Lclamp_\name
.Lclamped_\name:
        lsrs    r4, r4, #4
        ldr     r5, [sp, #FIELDS_AT]
        ands    r4, r4, r5
        lsrs    r5, r4, #16
        orrs    r4, r4, r5
        .if     \swaps
        rev16   r4, r4
        .endif
        ldr     r5, [sp, #COLOURS]
        strh    r4, [depth_at, r5]
.Lhidden_\name:
        add     depth, depth_right
        add     place, place_right
        add     colour, colour_right
        adds    depth_at, #2
        cmp     depth_at, depth_end
        bne     .Lsample_\name
.Lnext_row_\name:
        ldr     r7, [sp, #STATE]
        ldr     r6, [r7, #ROW_BYTES]
        adds    r7, #DOWN
        ldm     r7!, {r0-r3}            // down, row
        adds    r3, r3, r6
        subs    r7, #(ROW + 4 - QUANTITIES)
        ldm     r7!, {r4-r6}
        subs    r7, #12
        adds    r4, r4, r0
        adds    r5, r5, r1
        adds    r6, r6, r2
        stm     r7!, {r4-r6}
        str     r3, [r7, #(ROW - RIGHT)]
        ldr     r0, [sp, #STATE]
        ldr     r1, [r0, #COUNT]
        subs    r1, #1
        str     r1, [r0, #COUNT]
        bne     .Lrow_\name
        ldr     r2, [r0, #COUNT_BELOW]
        cmp     r2, #0
        beq     .Lend_\name
        str     r2, [r0, #COUNT]
        str     r1, [r0, #COUNT_BELOW]
        adds    r0, #BENT_EDGE
        ldm     r0!, {r1, r2, r3}
        ldr     r0, [sp, #STATE]
        lsls    r1, r1, #2
        adds    r1, r1, r0
        str     r2, [r1, #EDGES]
        str     r3, [r1, #STEPS]
        b       .Lrow_\name
.Lend_\name:
        add     sp, #FRAME_BYTES
        pop     {r4-r7}
        mov     r8, r4
        mov     r9, r5
        mov     r10, r6
        mov     r11, r7
        pop     {r4-r7, pc}
.Lclamp_\name:
        mov     r5, lr
        mov     r6, r12
        push    {r0-r3, r5, r6}
        movs    r0, r4
        bl      lumi_clamped
        movs    r4, r0
        pop     {r0-r3, r5, r6}
        mov     lr, r5
        mov     r12, r6
        b       .Lclamped_\name
        .pool
        .size   \name, . - \name
        .endm

        every_rows_loop
#endif
