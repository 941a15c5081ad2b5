# SPDX-License-Identifier: MIT
# Which emulated board runs code for which CPU, and how. Used by the firmware's build and by the host's tests.
#
# Code for Cortex-M0+ runs on the Cortex-M3 board: QEMU's one ARMv6-M board (micro:bit) has 16 KB of RAM, and every
# ARMv6-M instruction is an ARMv7-M instruction. The start-up code makes unaligned accesses fault, as an M0+ does.
set(LUMI_MPS2_CPUS cortex-m0plus cortex-m3 cortex-m4 cortex-m7)
set(LUMI_MPS2_BOARD_cortex-m0plus an385)
set(LUMI_MPS2_BOARD_cortex-m3 an385)
set(LUMI_MPS2_BOARD_cortex-m4 an386)
set(LUMI_MPS2_BOARD_cortex-m7 an500)

# Where -device loader puts a large field: loaded_field_memory() of the board.
set(LUMI_MPS2_PSRAM_an385 0x21000000)
set(LUMI_MPS2_PSRAM_an386 0x21000000)
set(LUMI_MPS2_PSRAM_an500 0x60000000)

# The command, as a list, that runs a program for `cpu`; -kernel FILE and options follow it. Semihosting output goes to
# standard output through its own channel: QEMU would send it to standard error.
function(lumi_mps2_emulator cpu out)
  set(${out} qemu-system-arm -M mps2-${LUMI_MPS2_BOARD_${cpu}} -display none -serial none -monitor none
    -chardev stdio,id=console -semihosting-config enable=on,target=native,chardev=console PARENT_SCOPE)
endfunction()
