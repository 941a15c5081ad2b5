# SPDX-License-Identifier: MIT
# For the Pico SDK: include(lumi/core/pico_lumi.cmake) after pico_sdk_init(), then target_link_libraries(firmware
# pico_lumi). As the SDK's own libraries are, an INTERFACE library that is compiled in the firmware, with the hot code
# in RAM. It gives both cores stacks of 4 kB, which drawing needs and the SDK's scratch banks hold. Others: set
# LUMI_PICO_STACK_SIZE before the include; where it is 0, nothing is defined and the firmware says it.
include(${CMAKE_CURRENT_LIST_DIR}/sources.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/cmake/lumi_add_field.cmake)
list(TRANSFORM LUMI_CORE_SOURCES PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
list(TRANSFORM LUMI_C_SOURCES PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
add_library(pico_lumi INTERFACE)
target_sources(pico_lumi INTERFACE ${LUMI_CORE_SOURCES} ${LUMI_C_SOURCES})
target_include_directories(pico_lumi INTERFACE ${CMAKE_CURRENT_LIST_DIR}/include ${CMAKE_CURRENT_LIST_DIR}/src)
target_compile_features(pico_lumi INTERFACE cxx_std_17)
target_compile_definitions(pico_lumi INTERFACE LUMI_HOT_SECTION=.time_critical.lumi)
if(NOT DEFINED LUMI_PICO_STACK_SIZE)
  set(LUMI_PICO_STACK_SIZE 0x1000)
endif()
if(LUMI_PICO_STACK_SIZE)
  target_compile_definitions(pico_lumi INTERFACE
    PICO_STACK_SIZE=${LUMI_PICO_STACK_SIZE} PICO_CORE1_STACK_SIZE=${LUMI_PICO_STACK_SIZE})
endif()
