// SPDX-License-Identifier: MIT
// Hints to GCC for inner loops, which must not pass their values through memory.
#pragma once

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
