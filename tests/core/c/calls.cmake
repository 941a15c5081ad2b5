# SPDX-License-Identifier: MIT
# The C99 part of the tests of lumi.h is a library of its own, as precompiled headers are C++.
add_library(lumi_calls_in_c STATIC ${CMAKE_CURRENT_LIST_DIR}/calls.c)
set_target_properties(lumi_calls_in_c PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
target_compile_options(lumi_calls_in_c PRIVATE -Wpedantic)
target_link_libraries(lumi_calls_in_c PRIVATE lumi::core lumi_options)
