# SPDX-License-Identifier: MIT
# ARMv4T, Thumb code unless a file says -marm (Game Boy Advance).
set(LUMI_ARM_CPU arm7tdmi)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
