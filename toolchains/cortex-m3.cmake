# SPDX-License-Identifier: MIT
# ARMv7-M: smull, udiv (STM32F1).
set(LUMI_ARM_CPU cortex-m3)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
