// SPDX-License-Identifier: MIT
// A hint about registers, of which Armv6-M has eight that its instructions reach. It changes no value.
#pragma once

#include <cstdint>

#include "lumi/detail/register_hints.h"

namespace lumi
{

// Both sums are brought up to date here. Without it compilers load the terms of a long sum before they add the first,
// and have to keep them in memory.
LUMI_ALWAYS_INLINE void settle([[maybe_unused]] uint32_t& a, [[maybe_unused]] uint32_t& b)
{
#if defined(__ARM_ARCH_6M__)
    __asm("" : "+l"(a), "+l"(b));
#elif defined(__thumb2__)
    __asm("" : "+r"(a), "+r"(b));
#endif
}

}  // namespace lumi
