# SPDX-License-Identifier: MIT
# find_package(lumi): the target lumi::core and the function lumi_add_field.
include(${CMAKE_CURRENT_LIST_DIR}/lumi-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/lumi_add_field.cmake)
