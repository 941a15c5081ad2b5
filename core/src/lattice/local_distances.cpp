// SPDX-License-Identifier: MIT
#include "lattice/local_distances.h"

#include "lumi/detail/math.h"
#include "math/generate.h"
#include "math/reciprocal.h"

namespace lumi::detail
{
namespace
{

// With f = (r_i² - r²)/(4r²), r_i - r = 2r·f·P(f) where P(f) = (sqrt(1 + 4f) - 1)/(2f) = 2/(1 + sqrt(1 + 4f)). A point
// within a spacing has f in [-0.21, 0.40] where the query is at kCapHeight, and nearer to 0 elsewhere.
struct Spreads {
    static constexpr int kStepBits = 9;
    static constexpr int32_t kFirstQ16 = -(28 << kStepBits);
    static constexpr int32_t kSteps = 84;

    uint16_t q14[kSteps + 1];

    // Returns P(f) for f at such a way from kFirstQ16, below the table's end.
    int32_t at(uint32_t from_first_q16) const
    {
        const uint16_t* entry = &q14[from_first_q16 >> kStepBits];
        const auto part = static_cast<int32_t>(from_first_q16 & ((1u << kStepBits) - 1));
        return entry[0] + (((entry[1] - entry[0]) * part) >> kStepBits);
    }
};
constexpr Spreads make_spreads()
{
    Spreads t{};
    for (int k = 0; k <= Spreads::kSteps; ++k) {
        const double f = (Spreads::kFirstQ16 + (k << Spreads::kStepBits)) / 65536.0;
        t.q14[k] = static_cast<uint16_t>(16384 * 2 / (1 + generate::root(1 + 4 * f)) + 0.5);
    }
    return t;
}

constexpr Spreads kSpreads = make_spreads();

constexpr uint32_t kEighthTurnQ16 = 51472;  // 2π/8
constexpr int32_t kHalfUnitQ14 = 1 << 13;

// Multiplies two numbers of one sign: within three spacings, or half a turn, that takes 32 bits and no sign.
uint32_t product(int32_t a, int32_t b)
{
    return static_cast<uint32_t>(a) * static_cast<uint32_t>(b);
}

}  // namespace

LocalDistances::LocalDistances(const Lattice& lattice, const Query& query, const Cell& cell)
{
    // r² = M·2^(2 - 2e), 1/r = y·2^(e - 1) with y = 1/sqrt(M) in [1, 2].
    const int32_t z = query.z_q30;
    const auto radius2_q30 = static_cast<uint32_t>(wide_product(kOneQ30 - z, kOneQ30 + z) >> 30);
    const int32_t e = __builtin_clz(radius2_q30) / 2;
    const uint32_t mantissa_q32 = radius2_q30 << (2 * e);
    const uint32_t root_q15 = coarse_inverse_root_q15(mantissa_q32);
    const uint32_t radius_q16 = ((mantissa_q32 >> 16) * root_q15) >> 15;
    shift_ = lattice.unit_bits() - e;  // 13 at least: from kCapHeight on, r is more than 1.6 spacings
    inverse_radius_q13_ = static_cast<int32_t>(root_q15 >> 2);
    radius_q16_ = (radius_q16 * kEighthTurnQ16) >> 16;
    slope_q14_ = (static_cast<uint32_t>(z >> 15) * root_q15) >> 16;
    slope_shift_ = e + 1;

    const int32_t south_q14 = lattice.index_step_q14();
    const auto to_south = [&](int32_t index) {
        return way(index, index * south_q14, static_cast<int32_t>(longitude_turns32(static_cast<uint32_t>(index))));
    };
    first_ = to_south(cell.first);
    second_ = to_south(cell.second);
    const int32_t index = cell.first * (cell.u_q12 >> 12) + cell.second * (cell.v_q12 >> 12);
    const int32_t whole = query.height_q10 >> 10;
    const int32_t part_q10 = query.height_q10 & 1023;
    corner_ = way(index, (index - whole) * south_q14 - part_q10 * (south_q14 >> 10),
                  static_cast<int32_t>(longitude_turns32(static_cast<uint32_t>(index)) - query.longitude_turns32));
    corner_.south_q14 += kHalfUnitQ14;
    corner_.east_q14 += kHalfUnitQ14;
    corner_.spread_q14 += kHalfUnitQ14;
}

LocalDistances::Way LocalDistances::way(int32_t index, int32_t south_q14, int32_t east_turns32) const
{
    const int32_t east = times_q16(east_turns32, radius_q16_);
    const int32_t spread = times_q16(south_q14, slope_q14_);
    return {index, south_q14, (east * (1 << (shift_ - 13))) >> 1, spread * (1 << slope_shift_)};
}

uint32_t LocalDistances::distance2(const Way& way) const
{
    LUMI_TALLY(Work::distance, 1);
    constexpr int32_t kTwelfthQ14 = 1365;
    constexpr int32_t kOneQ14 = 1 << 14;
    const int32_t w = way.south_q14 >> 14;
    const int32_t x = way.east_q14 >> 14;
    const uint32_t w2 = product(w, w);
    const uint32_t bent = ((w2 >> 14) * static_cast<uint32_t>(inverse_radius_q13_)) >> (shift_ + 1);
    const int32_t guess = (way.spread_q14 >> 14) - static_cast<int32_t>(bent);
    const uint32_t from_first_q16 =
        static_cast<uint32_t>(((guess * inverse_radius_q13_) >> (shift_ - 1)) - Spreads::kFirstQ16);
    if (from_first_q16 >= static_cast<uint32_t>(Spreads::kSteps) << Spreads::kStepBits) return UINT32_MAX;
    const int32_t spread = (guess * kSpreads.at(from_first_q16)) >> 14;
    const int32_t ratio_q14 = kOneQ14 + ((spread * inverse_radius_q13_) >> shift_);  // r_i/r
    const int32_t s_q14 = (x * inverse_radius_q13_) >> shift_;
    const int32_t sine_q14 =
        kOneQ14 - ((static_cast<int32_t>(product(s_q14, s_q14) >> 14) * kTwelfthQ14) >> 14);  // 4 sin²(s/2)/s²
    const int32_t scale_q14 = (ratio_q14 * sine_q14) >> 14;
    return w2 + product(spread, spread) + product(x, (x * scale_q14) >> 14);
}

}  // namespace lumi::detail
