# SPDX-License-Identifier: MIT
# cmake -D SOURCE=DIR -D VERSION=X.Y.Z "-D LIBRARIES=NAME VERSION, ..." -D OUT=FILE -P tools/packaging/version.cmake
# Writes a header with what `lumi --version` prints. A source tree that is no clone has no commit.
foreach(what IN ITEMS --show-prefix "--short=7;HEAD")
  execute_process(COMMAND git -C ${SOURCE} rev-parse ${what}
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  list(APPEND answers "${commit}")
endforeach()
set(text "lumi ${VERSION}")
if(NOT answers MATCHES "^.+;" AND commit)  # a prefix: a folder of another repository
  string(APPEND text " (${commit})")
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT [[// Written by tools/packaging/version.cmake.
#pragma once

namespace lumi_version
{

constexpr char kText[] = "@text@\nWith @LIBRARIES@";

}  // namespace lumi_version
]] @ONLY)
