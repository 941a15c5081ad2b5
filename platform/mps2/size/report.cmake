# SPDX-License-Identifier: MIT
# cmake -D SIZE=arm-none-eabi-size -D CPU=cpu -D FOLDER=dir -D "RECONSTRUCTIONS=..." -D "TEXELS=..." -D REPORT=file
#       -P report.cmake
# Bytes of flash (code and constants, libgcc included) that core adds to the start-up code of an empty program.
cmake_minimum_required(VERSION 3.25)

function(flash_bytes program out)
  execute_process(COMMAND ${SIZE} ${FOLDER}/lumi_size_${program}.elf OUTPUT_VARIABLE listing
    COMMAND_ERROR_IS_FATAL ANY)
  if(NOT listing MATCHES "\n *([0-9]+)[ \t]+([0-9]+)")
    message(FATAL_ERROR "not the output of size: ${listing}")
  endif()
  math(EXPR bytes "${CMAKE_MATCH_1} + ${CMAKE_MATCH_2}")
  set(${out} ${bytes} PARENT_SCOPE)
endfunction()

flash_bytes(empty empty)
flash_bytes(open open)
math(EXPR open "${open} - ${empty}")
list(JOIN TEXELS " | " titles)
string(REGEX REPLACE "[A-Za-z0-9]+" "---:" rule "${titles}")
set(table "Bytes of flash of core for ${CPU}; open_field and make_camera alone: ${open}\n\n")
string(APPEND table "| ${CPU} | ${titles} |\n|---| ${rule} |\n")
foreach(reconstruction IN LISTS RECONSTRUCTIONS)
  string(APPEND table "| ${reconstruction} |")
  foreach(texel IN LISTS TEXELS)
    flash_bytes(${reconstruction}_${texel} bytes)
    math(EXPR bytes "${bytes} - ${empty}")
    string(APPEND table " ${bytes} |")
  endforeach()
  string(APPEND table "\n")
endforeach()
file(WRITE ${REPORT} "${table}")
message("${table}")
