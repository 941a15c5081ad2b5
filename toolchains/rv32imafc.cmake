# SPDX-License-Identifier: MIT
# rv32imc.cmake with atomics and an FPU of single precision (ESP32-P4), which core does not touch.
set(LUMI_RISCV_ARCH rv32imafc)
set(LUMI_RISCV_ABI ilp32f)
include(${CMAKE_CURRENT_LIST_DIR}/riscv-unknown-elf.cmake)
