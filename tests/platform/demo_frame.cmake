# SPDX-License-Identifier: MIT
# cmake -D BOARDS=boards.cmake -D CPU=cpu -D PROGRAM=elf -D MODE=mode -D STACK_LIMIT=bytes -D PICTURE=prefix
#       -D TO_PNG=lumi_ppm_to_png -P demo_frame.cmake
# Draws one frame with lumi_demo_firmware, whose field is linked in. Passes if it reports instructions and a picture,
# and if the stack stayed below the limit.
cmake_minimum_required(VERSION 3.25)
include(${BOARDS})
lumi_mps2_command(emulator COUNT_INSTRUCTIONS CPU ${CPU} PROGRAM ${PROGRAM}
  ARGUMENTS --frames 1 --verify --mode ${MODE} --write ${PICTURE})
file(REMOVE ${PICTURE}-000.ppm ${PICTURE}-000.png)
execute_process(COMMAND ${emulator} OUTPUT_VARIABLE report RESULT_VARIABLE code)
message("${CPU} ${MODE}: ${report}")
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the program ended with ${code}")
endif()

set(number "[1-9][0-9]*")
set(hex_digit "[0-9a-f]")
string(REPEAT ${hex_digit} 8 crc)
set(pattern "^frame 000 crc ${crc} covered ${number} instructions ${number} per-covered ${number} stack (${number})")
if(NOT report MATCHES "${pattern}")
  message(FATAL_ERROR "this is not a frame's report")
endif()
if(CMAKE_MATCH_1 GREATER STACK_LIMIT)
  message(FATAL_ERROR "the stack went to ${CMAKE_MATCH_1} bytes; docs/firmware.md states ${STACK_LIMIT}")
endif()

# "P6\n240 240\n255\n" and three bytes a pixel
math(EXPR expected_bytes "15 + 240 * 240 * 3")
file(SIZE ${PICTURE}-000.ppm picture_bytes)
if(NOT picture_bytes EQUAL expected_bytes)
  message(FATAL_ERROR "the picture has ${picture_bytes} bytes instead of ${expected_bytes}")
endif()
execute_process(COMMAND ${TO_PNG} ${PICTURE}-000.ppm COMMAND_ERROR_IS_FATAL ANY)
file(READ ${PICTURE}-000.png png HEX)
if(NOT png MATCHES "^89504e470d0a1a0a0000000d49484452000000f0000000f008020000")  # the signature, and 240 by 240 pixels of RGB
  message(FATAL_ERROR "no PNG was made of the picture")
endif()
