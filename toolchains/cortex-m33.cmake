# SPDX-License-Identifier: MIT
# ARMv8-M Mainline with the DSP instructions (RP2350, STM32U5, nRF53).
set(LUMI_ARM_CPU cortex-m33)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
