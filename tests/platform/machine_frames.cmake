# SPDX-License-Identifier: MIT
# cmake -D COMPILER=c++ -D EMULATOR=qemu -D SOURCE=folder -D GENERATED=folder -D PROGRAM=file -D HOST=lumi_frame_crcs
#       -D FIELDS="f;f;f;f;f;f" [-D EVERY_FRAME=ON] [-D OPTIONS=options] -P machine_frames.cmake
# Builds the host's program by another compiler and passes if it writes the very lines that the host's writes.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE sources ${SOURCE}/core/src/*.cpp ${SOURCE}/platform/host/src/*.cpp ${GENERATED}/texel_frames_*.cpp)
list(FILTER sources EXCLUDE REGEX "/host/src/(picture|png_|ppm_)")  # lumi::png, whose libraries are of this machine
set(firmware ${SOURCE}/platform/mps2/firmware)
set(options -std=c++17 -O1 -static ${OPTIONS})
if(EVERY_FRAME)
  list(APPEND options -DLUMI_EVERY_FRAME)
endif()
execute_process(
  COMMAND ${COMPILER} ${options} -I${SOURCE}/core/include -I${SOURCE}/core/src -I${SOURCE}/platform/host/include
    -I${firmware} ${sources} ${SOURCE}/tests/platform/frame_crcs.cpp ${firmware}/frame_list.cpp
    ${firmware}/surface_frame_list.cpp -o ${PROGRAM}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${HOST} ${FIELDS} OUTPUT_VARIABLE expected COMMAND_ERROR_IS_FATAL ANY)
# A program without an operating system takes no long command line, so that it gets the names of the files alone.
list(GET FIELDS 0 folder)
get_filename_component(folder ${folder} DIRECTORY)
list(TRANSFORM FIELDS REPLACE "^.*/" "" OUTPUT_VARIABLE names)
execute_process(COMMAND ${EMULATOR} ${PROGRAM} ${names} WORKING_DIRECTORY ${folder}
  OUTPUT_VARIABLE found COMMAND_ERROR_IS_FATAL ANY)
if(NOT found STREQUAL expected OR expected STREQUAL "")
  message(FATAL_ERROR "the host draws\n${expected}\nand ${COMPILER}\n${found}")
endif()
string(REGEX MATCHALL "\n" lines "${expected}")
list(LENGTH lines count)
message("${count} frames, every bit the same on the host and by ${COMPILER}")
