# SPDX-License-Identifier: MIT
# ARMv8.1-M Mainline with the DSP instructions (Alif Ensemble, STM32N6). Soft float leaves the vector registers of MVE alone.
set(LUMI_ARM_CPU cortex-m55)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
