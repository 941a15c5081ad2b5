# SPDX-License-Identifier: MIT
# lumi_add_field(TARGET FIELD FILE [SYMBOL NAME] [SECTION NAME])
#
# Makes a field part of a program, an executable or a library of this folder: its bytes, and a header that tells all
# else, NAME.h (the file's name without .lumi). Written again when the field changes. SECTION: where the linker script
# wants the bytes, .rodata if not given. The C++ compiler takes the bytes in: project(... LANGUAGES C CXX) is enough.
#
# Needs the `lumi` command: of this build where it is for the host, else found by -DLUMI_TOOL=PATH or in PATH.
function(lumi_add_field target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "FIELD;SYMBOL;SECTION" "")
  if(NOT TARGET ${target})
    message(FATAL_ERROR "lumi_add_field: there is no target \"${target}\"; add it before")
  elseif(NOT arg_FIELD OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "lumi_add_field: write lumi_add_field(TARGET FIELD FILE [SYMBOL NAME] [SECTION NAME])")
  endif()
  if(NOT CMAKE_CXX_COMPILE_OBJECT)
    message(FATAL_ERROR "lumi_add_field: this project does not enable C++. Write\n  project(NAME LANGUAGES C CXX)")
  endif()
  if(TARGET lumi::lumi)
    set(tool $<TARGET_FILE:lumi::lumi>)
    set(tool_file ${tool})
  else()
    find_program(LUMI_TOOL lumi DOC "The lumi command, which runs on this machine" NO_CMAKE_FIND_ROOT_PATH)
    if(NOT LUMI_TOOL)
      message(FATAL_ERROR "lumi_add_field: the lumi command was not found. Build it on this machine "
        "(cmake --preset release && cmake --build --preset release) and give -DLUMI_TOOL=build/release/tools/lumi")
    endif()
    set(tool ${LUMI_TOOL})
    set(tool_file ${LUMI_TOOL})
  endif()

  get_filename_component(field "${arg_FIELD}" ABSOLUTE)
  if(NOT arg_SYMBOL)
    get_filename_component(stem "${field}" NAME_WE)
    string(MAKE_C_IDENTIFIER "${stem}" arg_SYMBOL)
  endif()
  set(section)
  if(arg_SECTION)
    set(section --section ${arg_SECTION})
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/lumi_fields/${target})
  set(source ${folder}/${arg_SYMBOL}.cpp)
  file(MAKE_DIRECTORY ${folder})
  add_custom_command(OUTPUT ${source} ${folder}/${arg_SYMBOL}.h
    COMMAND ${tool} embed ${field} -o ${source} --symbol ${arg_SYMBOL} --incbin ${field} ${section}
    DEPENDS ${field} ${tool_file} COMMENT "Embedding ${arg_FIELD}" VERBATIM)
  # The object depends on the bytes too: no compiler sees what an assembler includes. Link-time optimisation would lose
  # its symbols.
  set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS ${field} COMPILE_OPTIONS -fno-lto
    SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE ${source} ${folder}/${arg_SYMBOL}.h)
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
