/* SPDX-License-Identifier: MIT
 * A cartridge's first bytes: a branch, 156 bytes for the maker's logo (zeros here), title, code and their sum. */
    .section .lumi_vectors, "ax", %progbits
    .arm
    .global lumi_reset
lumi_reset:
    b start
    .space 156
    .ascii "LUMI CLOCK\0\0"
    .ascii "LUMP00"
    .byte 0x96, 0, 0
    .space 8
    .byte 0xf0  /* - (0x19 + the bytes from the title on) */
    .space 2
start:
    mov r0, #0x1F  /* system mode */
    msr cpsr_c, r0
    ldr sp, =lumi_stack_top
    ldr r0, =lumi_start
    bx r0
    .pool
