# SPDX-License-Identifier: MIT
# cmake -D HOST=lumi_frame_crcs -D BOARDS=boards.cmake -D CPU=cpu -D PROGRAM=elf -D FIELDS="f;f;f;f;f" -D FRAMES=count
#       -P compare_frames.cmake
# Passes if the program on the emulated board writes the very lines that the host program writes.
cmake_minimum_required(VERSION 3.25)
include(${BOARDS})
lumi_mps2_command(emulator CPU ${CPU} PROGRAM ${PROGRAM} FIELDS ${FIELDS})

execute_process(COMMAND ${HOST} ${FIELDS} OUTPUT_VARIABLE expected COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${emulator} OUTPUT_VARIABLE found RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the program on ${CPU} ended with ${code}:\n${found}")
endif()

string(REGEX REPLACE "\n$" "" expected "${expected}")
string(REGEX REPLACE "\r?\n$" "" found "${found}")
string(REPLACE "\n" ";" expected "${expected}")
string(REGEX REPLACE "\r?\n" ";" found "${found}")
list(LENGTH expected expected_count)
list(LENGTH found found_count)
if(NOT expected_count EQUAL found_count)
  message(FATAL_ERROR "the host draws ${expected_count} frames, ${CPU} ${found_count}")
endif()
# Fewer would prove less than it says.
if(expected_count LESS FRAMES)
  message(FATAL_ERROR "only ${expected_count} frames in the list instead of ${FRAMES}")
endif()

set(differences 0)
foreach(host_line board_line IN ZIP_LISTS expected found)
  if(NOT host_line STREQUAL board_line)
    message("host: ${host_line}\n${CPU}: ${board_line}")
    math(EXPR differences "${differences} + 1")
  endif()
endforeach()
if(differences)
  message(FATAL_ERROR "${differences} of ${expected_count} frames differ")
endif()
message("${expected_count} frames, every bit the same on the host and on ${CPU}")
