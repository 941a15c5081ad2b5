# SPDX-License-Identifier: MIT
# Runs a program on the emulated board for a CPU; fails if it does not exit with 0.
#
#   cmake -D CPU=cortex-m4 -D PROGRAM=program.elf [-D "ARGUMENTS=--frames;3"] [-D "FIELDS=a.lumi;b.lumi"]
#         [-D COUNT_INSTRUCTIONS=ON] -P platform/mps2/run.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/boards.cmake)
if(NOT CPU IN_LIST LUMI_MPS2_CPUS OR NOT EXISTS "${PROGRAM}")
  message(FATAL_ERROR "give -D CPU=cpu, one of: ${LUMI_MPS2_CPUS}; and -D PROGRAM=file, a program built for it")
endif()
set(options)
if(COUNT_INSTRUCTIONS)
  set(options COUNT_INSTRUCTIONS)
endif()

lumi_mps2_command(emulator CPU ${CPU} PROGRAM ${PROGRAM} ARGUMENTS ${ARGUMENTS} FIELDS ${FIELDS} ${options})
execute_process(COMMAND ${emulator} RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the program on ${CPU} ended with ${code}")
endif()
