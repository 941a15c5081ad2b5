// SPDX-License-Identifier: MIT
// The worst case of a sweep and where it is; printed, so that a run shows how much of a tolerance is used.
#pragma once

#include <cstdint>
#include <cstdio>

namespace lumi
{

// Sweeps are dense on the host and thinned out on an emulated target.
#ifdef LUMI_TEST_LIGHT
inline constexpr uint32_t kSweep = 8192;
#else
inline constexpr uint32_t kSweep = 1u << 20;
#endif

struct Worst {
    double error = 0;
    uint64_t where = 0;

    void see(double e, uint64_t at)
    {
        if (!(e <= error)) {
            error = e;
            where = at;
        }
    }

    void report(const char* what) const
    {
        std::printf("%s: worst %.3g at %llu\n", what, error, static_cast<unsigned long long>(where));
    }
};

}  // namespace lumi
