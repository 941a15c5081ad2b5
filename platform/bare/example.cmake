# SPDX-License-Identifier: MIT
# The examples without an SDK share this. An example is a project of its own:
#
#   cmake -S platform/riscv -B build/riscv -G Ninja --toolchain "$PWD/toolchains/rv32imc.cmake" \
#       -DLUMI_TOOL="$PWD/build/release/tools/lumi" -DLUMI_EXAMPLE_FIELD="$PWD/desk_clock.lumi"
#
# lm3s_oled has cortex-m3.cmake, pico_st7789 cortex-m0plus.cmake.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(LUMI_EXAMPLE_FIELD "" CACHE FILEPATH "The surface field that the example draws")
if(NOT LUMI_EXAMPLE_FIELD)
  message(FATAL_ERROR "name a surface field: -DLUMI_EXAMPLE_FIELD=desk_clock.lumi")
endif()
get_filename_component(lumi_root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
add_subdirectory(${lumi_root}/core ${CMAKE_CURRENT_BINARY_DIR}/core EXCLUDE_FROM_ALL)
target_compile_definitions(lumi_core PUBLIC LUMI_HOT_SECTION=.lumi_hot)  # hot.ld says where it goes

set(lumi_example_warnings -Wall -Wextra -Wshadow -Wconversion -Wsign-conversion -Werror)

# lumi_bare_example(NAME SOURCE...): a program with our own start-up and the linker script of the example's folder.
function(lumi_bare_example name)
  set(bare ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  add_executable(${name} ${ARGN} ${bare}/start.cpp)
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${bare} ${bare}/../mps2/firmware)
  target_compile_options(${name} PRIVATE ${lumi_example_warnings} -ffunction-sections -fdata-sections
    $<$<COMPILE_LANGUAGE:CXX>:-fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-tree-loop-distribute-patterns>)
  target_link_libraries(${name} PRIVATE lumi::core)
  target_link_options(${name} PRIVATE -nostartfiles -Wl,--gc-sections -Wl,--no-warn-rwx-segments
    -L${CMAKE_CURRENT_SOURCE_DIR} -L${bare} -T${CMAKE_CURRENT_SOURCE_DIR}/link.ld)
  file(GLOB scripts ${CMAKE_CURRENT_SOURCE_DIR}/*.ld ${bare}/*.ld)
  set_target_properties(${name} PROPERTIES LINK_DEPENDS "${scripts}")
  lumi_add_field(${name} FIELD ${LUMI_EXAMPLE_FIELD} SYMBOL desk_clock)
endfunction()
