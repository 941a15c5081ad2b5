// SPDX-License-Identifier: MIT
// Inner loops must not pass their values through memory.
#pragma once

#define LUMI_ALWAYS_INLINE __attribute__((always_inline)) inline
