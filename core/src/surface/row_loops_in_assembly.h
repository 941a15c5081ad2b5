// SPDX-License-Identifier: MIT
// Which parts have loops for 5-6-5 pixels in assembly: armv6m/rows.S, armv7m/rows.S.
#pragma once

#if defined(__ARM_ARCH_6M__) || (defined(__thumb2__) && __ARM_ARCH_PROFILE == 'M')
#define LUMI_ROW_LOOPS_IN_ASSEMBLY 1
#endif
