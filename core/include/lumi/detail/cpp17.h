// SPDX-License-Identifier: MIT
// A compiler of an older C++ says this, and no more: the file that is not there ends it, before errors of the
// language hide the remedy.
#pragma once

// clang-format off
#if __cplusplus < 201703L
#ifdef ARDUINO
#error "Lumi needs C++17, and the package of this board compiles an older C++. Update it in the Boards Manager (esp32: 3.0 or later, stm32: 2.5 or later), or write compiler.cpp.extra_flags=-std=gnu++17 into a file platform.local.txt beside its platform.txt."
#else
#error "lumi needs C++17: compile with -std=c++17, -std=gnu++17 or a later standard."
#endif
#include <see_the_error_above>
#endif
// clang-format on
