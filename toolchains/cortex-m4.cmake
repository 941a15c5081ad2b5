# SPDX-License-Identifier: MIT
# ARMv7E-M: adds the DSP instructions (STM32F4, nRF52).
set(LUMI_ARM_CPU cortex-m4)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
