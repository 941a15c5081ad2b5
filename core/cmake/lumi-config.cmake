# SPDX-License-Identifier: MIT
# find_package(lumi): the target lumi::core and the function lumi_add_field.
if(NOT CMAKE_CXX_COMPILE_OBJECT)
  message(FATAL_ERROR "lumi is C++17, which this project does not enable. Write\n  project(NAME LANGUAGES C CXX)")
endif()
include(${CMAKE_CURRENT_LIST_DIR}/lumi-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/lumi_add_field.cmake)
