// SPDX-License-Identifier: MIT
// The kernel's weights, (1 - d²)² of distances in spacings, of the four points near a pixel.
#pragma once

#include "lumi/chord/detail/kernel/distances.h"

namespace lumi::detail
{

// Reciprocals of sums of weights from 1/2 to 3/2 in 256 parts, times 1 + 2^-8: a sum's product with its own is from 1
// to 1 + 2^-7, half a unit of seven bits too much in the mean, so that shares rounded down are rounded. Larger sums,
// which no lattice has, share the last one, that of 4.
struct SumReciprocals {
    static constexpr int32_t kCount = 256;
    static constexpr int32_t kFirstQ20 = 1 << 19;
    uint16_t q11[kCount];
};
extern const SumReciprocals kSumReciprocals;

// Weights of four points, normalised to 2^kBits. Sums are rounded, not weights, so that none of those falls below zero.
struct NearWeights {
    uint32_t weight[4];

    template <int kBits, uint32_t K>
    LUMI_ALWAYS_INLINE static NearWeights of(const NearPoints& near)
    {
        uint32_t w[4];
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) w[k] = static_cast<uint32_t>(square_of_top(near.below_q26[k]));  // Q20
        for (uint32_t k = K; k < 4; ++k) drop_lightest(w);
        const uint32_t two = w[0] + w[1];
        const uint32_t three = two + w[2];
        uint32_t inverse_q11 = reciprocal_q11(three + w[3]);
        if (kBits > 7) inverse_q11 -= inverse_q11 >> 7;  // what is above 1 would show
        const auto share = [&](uint32_t sum) { return (sum * inverse_q11) >> (31 - kBits); };
        const uint32_t share1 = share(w[0]);
        const uint32_t share2 = share(two);
        const uint32_t share3 = share(three);
        return {{share1, share2 - share1, share3 - share2, (1u << kBits) - share3}};
    }

private:
    static uint32_t reciprocal_q11(uint32_t sum_q20)
    {
        const int32_t k = (static_cast<int32_t>(sum_q20) - SumReciprocals::kFirstQ20) >> 12;
        constexpr int32_t kLast = SumReciprocals::kCount - 1;
        return kSumReciprocals.q11[k < 0 ? 0 : k < kLast ? k : kLast];
    }
    static int32_t square_of_top(int32_t v)
    {
        return (v >> 16) * (v >> 16);
    }
    static void drop_lightest(uint32_t w[4])
    {
        int lightest = 0;
        for (int k = 1; k < 4; ++k)
            if (w[k] != 0 && (w[lightest] == 0 || w[k] < w[lightest])) lightest = k;
        w[lightest] = 0;
    }
};

}  // namespace lumi::detail
