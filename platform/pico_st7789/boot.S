/* SPDX-License-Identifier: MIT
 * Second stage of the RP2040's boot: the boot ROM copies these 256 bytes to RAM, checks their CRC (add_boot_crc.py writes
 * it) and calls them. They let the flash be read at its addresses by the command that every flash knows, 03h, at a
 * quarter of the CPU's clock, and start the program. */
    .syntax unified
    .cpu cortex-m0plus
    .thumb
    .section .lumi_boot, "ax", %progbits
    .thumb_func
boot:
    ldr r0, =0x18000000  /* SSI */
    movs r1, #0
    str r1, [r0, #0x08]  /* off */
    movs r1, #4
    str r1, [r0, #0x14]  /* divider */
    ldr r1, =(31 << 16 | 3 << 8)  /* 32 bits a read; send a command, then read */
    str r1, [r0, #0x00]
    ldr r1, =(0x03 << 24 | 2 << 8 | 6 << 2)  /* command, its 8 bits, 24 bits of address */
    movs r2, #0xf4
    str r1, [r0, r2]
    movs r1, #0
    str r1, [r0, #0x04]
    movs r1, #1
    str r1, [r0, #0x08]  /* on */
    ldr r0, =0x10000100
    ldr r1, =0xE000ED08  /* VTOR */
    str r0, [r1]
    ldm r0!, {r1, r2}
    msr msp, r1
    bx r2
    .pool
    .balign 4
    .fill (252 - (. - boot)), 1, 0
    .word 0  /* CRC */
