# SPDX-License-Identifier: MIT
# The texel formats that core draws: AllTexels of core/include/lumi/chord/texel.h, the one list of them.
set(lumi_texel_header ${CMAKE_CURRENT_LIST_DIR}/../include/lumi/chord/texel.h)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${lumi_texel_header})
file(STRINGS ${lumi_texel_header} lumi_texels REGEX "^using AllTexels = ")
string(REGEX MATCHALL "Texel[A-Z][A-Za-z0-9]*[,>]" lumi_texels "${lumi_texels}")
string(REGEX REPLACE "[,>]" "" LUMI_TEXELS "${lumi_texels}")
string(REGEX REPLACE "Texel([^;]+)" "\\1" LUMI_TEXEL_NAMES "${LUMI_TEXELS}")
string(TOLOWER "${LUMI_TEXEL_NAMES}" LUMI_TEXEL_NAMES)
if(NOT LUMI_TEXELS)
  message(FATAL_ERROR "${lumi_texel_header} has no line 'using AllTexels = TexelList<...'")
endif()

# lumi_texel_sources(TARGET TEMPLATE): the template's code for each format, in files of their own, so that they compile
# side by side.
function(lumi_texel_sources target template)
  cmake_path(GET template STEM LAST_ONLY stem)  # x.cpp of x.cpp.in
  cmake_path(REMOVE_EXTENSION stem)
  foreach(LUMI_TEXEL IN LISTS LUMI_TEXELS)
    set(file ${CMAKE_CURRENT_BINARY_DIR}/${stem}_${LUMI_TEXEL}.cpp)
    configure_file(${template} ${file} @ONLY)
    set_source_files_properties(${file} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    target_sources(${target} PRIVATE ${file})
  endforeach()
endfunction()
