# SPDX-License-Identifier: MIT
# RISC-V with products, division and compressed instructions (ESP32-C3).
set(LUMI_RISCV_ARCH rv32imc)
set(LUMI_RISCV_ABI ilp32)
include(${CMAKE_CURRENT_LIST_DIR}/riscv-unknown-elf.cmake)
