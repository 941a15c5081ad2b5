// SPDX-License-Identifier: MIT
// Whether this is the build of tools/lab/fuzz.sh. It reads what any other build reads. But thousands of inputs a second
// are worth more there than exact tables and large pictures, so it takes few samples, and refuses what takes long.
#pragma once

namespace lumi::baker
{

#ifdef LUMI_FUZZED
inline constexpr bool kIsFuzzed = true;
#else
inline constexpr bool kIsFuzzed = false;
#endif

}  // namespace lumi::baker
