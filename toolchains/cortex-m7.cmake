# SPDX-License-Identifier: MIT
# ARMv7E-M, dual issue, caches (STM32H7).
set(LUMI_ARM_CPU cortex-m7)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
