# SPDX-License-Identifier: MIT
# ARMv4T, as in a Game Boy Advance: Thumb code unless a file says -marm.
set(LUMI_ARM_CPU arm7tdmi)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
