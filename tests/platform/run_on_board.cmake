# SPDX-License-Identifier: MIT
# cmake -D BOARDS=boards.cmake -D CPU=cpu -D KERNEL=elf [-D ARGUMENTS=...] -P run_on_board.cmake
# Runs a program on its emulated board; passes if it exits with 0.
cmake_minimum_required(VERSION 3.25)
include(${BOARDS})
lumi_mps2_command(emulator CPU ${CPU} KERNEL ${KERNEL} ARGUMENTS ${ARGUMENTS})
execute_process(COMMAND ${emulator} RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the program on ${CPU} ended with ${code}")
endif()
