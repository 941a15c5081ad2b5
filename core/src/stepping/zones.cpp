// SPDX-License-Identifier: MIT
#include "lumi/detail/stepping/zones.h"

#include "math/generate.h"
#include "lumi/math.h"
#include "lattice/polar.h"

namespace lumi
{
namespace
{

struct PowerTables {
    int32_t inverse_q30[kFirstSpanZone + kSpanZones + 1];      // Φ^-k
    uint32_t zone_q10[2 * (kFirstSpanZone + kSpanZones) + 1];  // Φ^m/(√5·π)
};

constexpr PowerTables make_tables()
{
    PowerTables t{};
    double inverse = 1;
    for (int32_t& v : t.inverse_q30) {
        v = static_cast<int32_t>(kOneQ30 * inverse);
        inverse /= generate::kGolden;
    }
    double power = 1 / (generate::root(5) * generate::kPi);
    for (uint32_t& v : t.zone_q10) {
        v = static_cast<uint32_t>(1024 * power);
        power *= generate::kGolden;
    }
    return t;
}

constexpr PowerTables kPowers = make_tables();

constexpr int kScaleBits = 14;

static_assert(kSpanCapReach < polar::kReach && polar::kPoints <= kMinReachLattice);

// |z| where n·(1 - z²) has the given value; 0 where it is never reached.
int32_t height_of_q30(uint32_t n_sine2_q10, const Lattice& lattice)
{
    const uint64_t sine2_q30 = (static_cast<uint64_t>(n_sine2_q10) * lattice.reciprocal_q30()) >> 10;
    if (sine2_q30 >= static_cast<uint64_t>(kOneQ30)) return 0;
    return static_cast<int32_t>(square_root((static_cast<uint64_t>(kOneQ30) - sine2_q30) << 30));
}

// z of a real-valued index on this hemisphere; -1 where there is none.
int32_t height_of_index_q30(const Lattice& lattice, int32_t index)
{
    return static_cast<uint32_t>(index) < lattice.size() ? lattice.height_at_q30(index << 10) : -1;
}

SpanZone make_zone(const Lattice& lattice, int k)
{
    const uint32_t n = lattice.size();
    SpanZone z{};
    z.number = static_cast<int16_t>(k);
    z.begin_z_q30 = height_of_q30(kPowers.zone_q10[2 * k], lattice);
    z.obtuse_z_q30 = height_of_q30(kPowers.zone_q10[2 * k + 1], lattice);
    // Where even the equator is acute, no cell is obtuse, not even those whose middle lies beyond the equator.
    z.obtuse_index_q10 = z.obtuse_z_q30 != 0 ? lattice.index_at_q10(z.obtuse_z_q30) : static_cast<int32_t>(n << 10);
    // v = Φ^-k·n/2·(1 - |z|) - Φ^-k/2: z comes in Q16, coordinates leave in Q16.
    const uint64_t v_q31 = static_cast<uint64_t>(n) * static_cast<uint32_t>(kPowers.inverse_q30[k]);
    const uint64_t u_q31 = static_cast<uint64_t>(n) * static_cast<uint32_t>(kPowers.inverse_q30[k + 1]);
    const auto beyond = static_cast<uint32_t>(v_q31 >> kScaleBits);  // v < 2^42
    const int down = beyond == 0 ? 0 : 32 - __builtin_clz(beyond);
    z.scale_v = static_cast<int16_t>(v_q31 >> down);
    z.scale_u = static_cast<int16_t>(u_q31 >> down);
    z.shift = static_cast<int16_t>(31 - down);
    z.origin_v_q16 = static_cast<int32_t>(v_q31 >> 15) - (kPowers.inverse_q30[k] >> 15);
    z.origin_u_q16 = static_cast<int32_t>(u_q31 >> 15) - (kPowers.inverse_q30[k + 1] >> 15);
    return z;
}

}  // namespace

SpanLattice::SpanLattice(const Lattice& lattice)
    : size(static_cast<int32_t>(lattice.size())),
      cap_z_q30(height_of_index_q30(lattice, kSpanCapHeight)),
      reach_z_q30(lattice.size() < kMinReachLattice ? cap_z_q30 : height_of_index_q30(lattice, kSpanCapReach)),
      mirror_turns20(static_cast<int32_t>(longitude_turns32(lattice.size() - 1) >> 12)),
      step_z_q30(static_cast<int32_t>(lattice.reciprocal_q30())),
      zone{}
{
    const SinCos mirror = sin_cos(longitude_turns32(lattice.size() - 1));
    mirror_cos_q15 = mirror.cos_q30 >> 15;
    mirror_sin_q15 = mirror.sin_q30 >> 15;
    // Zones beyond the equator's are left zero: no height is below theirs.
    for (int k = 0; k < kSpanZones; ++k) {
        zone[k] = make_zone(lattice, kFirstSpanZone + k);
        if (zone[k].begin_z_q30 == 0) break;
    }
}

int32_t SpanSide::highest(int32_t length) const
{
    if (cap != nullptr) return first > 0 ? static_cast<int32_t>(polar::kPoints) - 1 : base;
    const auto index = [&](int32_t u, int32_t v) { return base + first * (u >> 16) + second * (v >> 16); };
    const int32_t a = index(u_q16, v_q16);
    const int32_t b = index(u_q16 + length * du_q16, v_q16 + length * dv_q16);
    // A floor takes up to one step off either coordinate, and a cell's corners lie up to both steps on.
    return (a > b ? a : b) + 2 * (magnitude(first) + magnitude(second));
}

}  // namespace lumi
