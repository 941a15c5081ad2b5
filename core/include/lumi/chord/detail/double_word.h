// SPDX-License-Identifier: MIT
// Two words that an inner loop keeps in memory and reads by one instruction where there is one (LDRD of Armv7-M), in
// place of two registers or of two that a compiler spills one by one.
#pragma once

#include "lumi/detail/register_hints.h"

namespace lumi::detail
{

template <class A, class B = A>
struct DoubleWord {
    A a;
    B b;
};

template <class A, class B>
LUMI_ALWAYS_INLINE DoubleWord<A, B> reload(const DoubleWord<A, B>& words)
{
#ifdef __ARM_FEATURE_DSP
    static_assert(sizeof(A) == 4 && sizeof(B) == 4, "LDRD loads words");
    A a;
    B b;
    asm volatile("ldrd %0, %1, %2" : "=r"(a), "=r"(b) : "m"(words));
    return {a, b};
#else
    return words;
#endif
}

}  // namespace lumi::detail
