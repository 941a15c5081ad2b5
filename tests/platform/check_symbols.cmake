# SPDX-License-Identifier: MIT
# cmake -D NM=arm-none-eabi-nm -D "FILES=lib;lib" [-D FORBIDDEN=regex] [-D EXPECT_VIOLATION=ON] -P check_symbols.cmake
# Passes if no object, library or program names a symbol of heap, exceptions, run-time types or floating point, or that
# matches FORBIDDEN where it is given; with EXPECT_VIOLATION, if one does.
cmake_minimum_required(VERSION 3.25)
set(forbidden
  # heap
  "(_?_)?(malloc|calloc|realloc|free|aligned_alloc|memalign)(_r)?" "_?sbrk(_r)?"
  "_Zn[wa].*" "_Zd[la].*"
  # exceptions, run-time types, guarded statics
  "__cxa_.*" "__gxx_personality.*" "_Unwind_.*" "__aeabi_unwind_cpp_pr[12]" "_ZT[IVS].*" "__dynamic_cast"
  # floating point: conversions, arithmetic, comparisons; integer division (ldivmod, uldivmod, idiv, lmul) is no match
  "__aeabi_[fd](add|sub|rsub|mul|div|neg|cmp[a-z]*|2[a-z0-9]+)" "__aeabi_c[fd]r?cmp[a-z]*"
  "__aeabi_u?[il]2[fdh]" "__aeabi_h2f[a-z_]*"
  "__(add|sub|mul|div|neg|eq|ne|lt|le|gt|ge|cmp|unord|pow|powi)[sdxt][fc][23i]*"
  "__(fix|fixuns|float|floatun|floatuns)[sdxt][if][sdxt][if]" "__(extend|trunc)[sdhxt]f[sdhxt]f2"
  "(sqrt|sin|cos|tan|asin|acos|atan|atan2|exp|log|pow|floor|ceil|round|fmod|ldexp)f?")
if(DEFINED FORBIDDEN)
  set(forbidden "${FORBIDDEN}")
endif()

execute_process(COMMAND ${NM} --format=posix ${FILES} OUTPUT_VARIABLE listing COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "\n" ";" listing "${listing}")
set(symbols ${listing})
list(FILTER symbols INCLUDE REGEX "^[^ ]+ [A-Za-z]( |$)")
list(TRANSFORM symbols REPLACE " .*" "")
list(LENGTH symbols count)
set(violations)
foreach(pattern IN LISTS forbidden)
  set(found ${symbols})
  list(FILTER found INCLUDE REGEX "^(${pattern})$")
  list(APPEND violations ${found})
endforeach()
list(REMOVE_DUPLICATES violations)
list(JOIN violations "\n  " shown)

if(count EQUAL 0)
  message(FATAL_ERROR "no symbols were read from ${FILES}")
endif()
if(EXPECT_VIOLATION)
  if(NOT violations)
    message(FATAL_ERROR "the planted violation in ${FILES} was not found")
  endif()
  message("found, as it should be:\n  ${shown}")
elseif(violations)
  message(FATAL_ERROR "these must not be there:\n  ${shown}")
else()
  message("${count} symbols, none that is forbidden")
endif()
