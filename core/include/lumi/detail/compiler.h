// SPDX-License-Identifier: MIT
// Core asks this of a compiler: C++17, hints for inner loops, and a place for them.
#pragma once

// A compiler of an older C++ says this, and no more: the file that is not there ends it, before errors of the
// language hide the remedy.
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

// A build may say where the functions lie that take a surface frame's time, about 5 kB of code: where the chip is fast.
//
//     -DLUMI_HOT_SECTION=.time_critical.lumi                                        (Pico; .iram1, .itcm, ...)
//     -D'LUMI_HOT=__attribute__((section(".iwram"), target("arm"), long_call))'     (any attributes)
//
// The whole build has to say the same. GCC before 14 ignores sections of templates: the loops that store pixels, and
// those of chord fields, are placed by the linker script alone, as .text._ZN4lumi* (-ffunction-sections).
#ifndef LUMI_HOT
#ifdef LUMI_HOT_SECTION
#define LUMI_SECTION_NAME(name) #name
#define LUMI_IN_SECTION(name) __attribute__((section(LUMI_SECTION_NAME(name))))
#define LUMI_HOT LUMI_IN_SECTION(LUMI_HOT_SECTION)
#else
#define LUMI_HOT
#endif
#endif

// These are hints to GCC for inner loops, which must not pass their values through memory.
#define LUMI_ALWAYS_INLINE __attribute__((always_inline)) inline

namespace lumi::detail
{

// Keeps a value in a register as it is, so that GCC does not take sums of addresses apart again.
template <class T>
LUMI_ALWAYS_INLINE T settled(T value)
{
    asm("" : "+r"(value));
    return value;
}

// Ends one part of a long computation before the next begins, so that no more values than fit registers are alive.
LUMI_ALWAYS_INLINE void end_part()
{
    asm volatile("" ::: "memory");
}

}  // namespace lumi::detail
