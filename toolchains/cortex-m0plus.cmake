# SPDX-License-Identifier: MIT
# ARMv6-M: no 64-bit product, no hardware divide, no unaligned access (RP2040).
set(LUMI_ARM_CPU cortex-m0plus)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
