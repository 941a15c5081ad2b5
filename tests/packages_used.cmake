# SPDX-License-Identifier: MIT
# cmake -D NM=nm -D PROGRAM=lumi -D TESTS=test_program -P packages_used.cmake
# Fails where one of the packages that the project was asked to use is no longer used: Catch2 tests, tinyobjloader reads OBJ
# files, and stb_image_write writes all PNG files, so that libpng only reads.
cmake_minimum_required(VERSION 3.25)

function(read_symbols program out)
  execute_process(COMMAND ${NM} -C ${program} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  set(${out} "${symbols}" PARENT_SCOPE)
endfunction()

read_symbols(${PROGRAM} program)
read_symbols(${TESTS} tests)
set(missing)
if(NOT program MATCHES " T stbi_write_png_to_mem\n")
  list(APPEND missing "stb_image_write (${PROGRAM})")
endif()
if(NOT program MATCHES "tinyobj::LoadObjWithCallback")
  list(APPEND missing "tinyobjloader (${PROGRAM})")
endif()
if(NOT tests MATCHES "Catch::AssertionHandler")
  list(APPEND missing "Catch2 (${TESTS})")
endif()
if(missing)
  list(JOIN missing ", " missing)
  message(FATAL_ERROR "no longer used: ${missing}")
endif()
if(program MATCHES " U (png_[a-z_]*write[a-z_]*)")
  message(FATAL_ERROR "${PROGRAM}: ${CMAKE_MATCH_1} of libpng is used, which shall only read")
endif()
