// SPDX-License-Identifier: MIT
// The files LUMI_SURFACE_MODULE and LUMI_CHORD_MODULE, byte for byte, and their sizes in 32 bits.
    .section .rodata
    .global lumi_surface_module, lumi_surface_module_bytes, lumi_chord_module, lumi_chord_module_bytes
    .balign 4
lumi_surface_module_bytes:
    .long lumi_surface_module_end - lumi_surface_module
lumi_chord_module_bytes:
    .long lumi_chord_module_end - lumi_chord_module
lumi_surface_module:
    .incbin LUMI_SURFACE_MODULE
lumi_surface_module_end:
lumi_chord_module:
    .incbin LUMI_CHORD_MODULE
lumi_chord_module_end:
    .section .note.GNU-stack, "", %progbits
