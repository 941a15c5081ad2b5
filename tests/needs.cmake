# SPDX-License-Identifier: MIT
# A tree with tests needs this besides what builds `lumi`, as far as .ci/run demands it (tools/install_packages.sh tests).

# Programs of the tests on emulated boards.
set(LUMI_CROSS_PROGRAMS arm-none-eabi-gcc arm-none-eabi-g++ arm-none-eabi-nm qemu-system-arm)
# Compiler and emulator of another machine that draws the frames.
set(LUMI_MACHINE_PROGRAMS s390x-linux-gnu-g++ qemu-s390x)

# lumi_find_program(PROGRAM OUT): whether the program is in PATH.
function(lumi_find_program program out)
  string(MAKE_C_IDENTIFIER "LUMI_FOUND_${program}" found)
  find_program(${found} ${program})
  mark_as_advanced(${found})
  set(${out} ${${found}} PARENT_SCOPE)
endfunction()

# lumi_missing_test_needs(OUT): a list of what is not installed.
function(lumi_missing_test_needs out)
  set(missing)
  # Boards' toolchains look into their own folders alone.
  find_path(LUMI_CATCH2_HEADER NAMES catch2/catch.hpp catch2/catch_all.hpp PATHS /usr/local/include /usr/include NO_CMAKE_FIND_ROOT_PATH)
  mark_as_advanced(LUMI_CATCH2_HEADER)
  if(NOT LUMI_CATCH2_HEADER)
    list(APPEND missing Catch2)
  endif()
  foreach(program IN ITEMS python3 LISTS LUMI_CROSS_PROGRAMS LUMI_MACHINE_PROGRAMS)
    lumi_find_program(${program} found)
    if(NOT found)
      list(APPEND missing ${program})
    endif()
  endforeach()
  set(${out} ${missing} PARENT_SCOPE)
endfunction()
