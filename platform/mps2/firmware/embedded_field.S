// SPDX-License-Identifier: MIT
// The file LUMI_FIRMWARE_FIELD, byte for byte: the assembler copies 4 MB in a blink where a C array costs a compiler gigabytes.
    .section .lumi_field, "a", %progbits
    .balign 8
    .global lumi_field_start, lumi_field_end
lumi_field_start:
    .incbin LUMI_FIRMWARE_FIELD
lumi_field_end:
