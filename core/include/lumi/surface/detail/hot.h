// SPDX-License-Identifier: MIT
// Where the chip is fast. A build may say where the functions lie that take a surface frame's time, about 5 kB of code:
//
//     -DLUMI_HOT_SECTION=.time_critical.lumi                                        (Pico; .iram1, .itcm, ...)
//     -D'LUMI_HOT=__attribute__((section(".iwram"), target("arm"), long_call))'     (any attributes)
//
// The whole build has to say the same. GCC before 14 ignores sections of templates: the loops that store pixels, and
// those of chord fields, are placed by the linker script alone, as .text._ZN4lumi* (-ffunction-sections).
#pragma once

#ifndef LUMI_HOT
#ifdef LUMI_HOT_SECTION
#define LUMI_SECTION_NAME(name) #name
#define LUMI_IN_SECTION(name) __attribute__((section(LUMI_SECTION_NAME(name))))
#define LUMI_HOT LUMI_IN_SECTION(LUMI_HOT_SECTION)
#else
#define LUMI_HOT
#endif
#endif
