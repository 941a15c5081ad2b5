// SPDX-License-Identifier: MIT
// The least and the most of three.
#pragma once

#include <stdint.h>

#include "lumi/detail/register_hints.h"

namespace lumi::detail
{

LUMI_ALWAYS_INLINE int32_t least_of(int32_t a, int32_t b, int32_t c)
{
    const int32_t ab = a < b ? a : b;
    return ab < c ? ab : c;
}
LUMI_ALWAYS_INLINE int32_t most_of(int32_t a, int32_t b, int32_t c)
{
    const int32_t ab = a > b ? a : b;
    return ab > c ? ab : c;
}

}  // namespace lumi::detail
