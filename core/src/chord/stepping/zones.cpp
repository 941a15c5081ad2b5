// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/stepping/zones.h"

#include "lattice/polar.h"
#include "lattice/zone_tables.h"
#include "lumi/detail/math.h"

namespace lumi::detail
{
namespace
{

constexpr int kScaleBits = 14;

static_assert(kPolarHeight < polar::kWalkReach && polar::kPoints <= kMinSpanLattice);
static_assert(kFirstSpanZone == kPolarZone);

// |z| where n·(1 - z²) has the given value; 0 where it is never reached.
int32_t height_of_q30(uint32_t n_sine2_q10, const Lattice& lattice)
{
    const uint64_t sine2_q30 = (static_cast<uint64_t>(n_sine2_q10) * lattice.reciprocal_q30()) >> 10;
    if (sine2_q30 >= static_cast<uint64_t>(kOneQ30)) return 0;
    return static_cast<int32_t>(square_root((static_cast<uint64_t>(kOneQ30) - sine2_q30) << 30));
}

// Where even the equator is acute, no cell is obtuse, not even those whose middle lies beyond the equator.
int32_t obtuse_index_q10(const Lattice& lattice, const Zone& z)
{
    if (z.number == kPolarZone) return kObtuseHeight << 10;
    return z.obtuse_z_q30 != 0 ? lattice.index_at_q10(z.obtuse_z_q30) : static_cast<int32_t>(lattice.size() << 10);
}

Zone make_zone(const Lattice& lattice, int k)
{
    const uint32_t n = lattice.size();
    Zone z{};
    z.number = static_cast<int16_t>(k);
    z.begin_z_q30 = height_of_q30(kZoneTables.threshold_q10[2 * k], lattice);
    z.obtuse_z_q30 = height_of_q30(kZoneTables.threshold_q10[2 * k + 1], lattice);
    z.obtuse_index_q10 = obtuse_index_q10(lattice, z);
    // v = Φ^-k·n/2·(1 - |z|) - Φ^-k/2: z comes in Q16, coordinates leave in Q16.
    const uint64_t v_q31 = static_cast<uint64_t>(n) * static_cast<uint32_t>(kZoneTables.inverse_power_q30[k]);
    const uint64_t u_q31 = static_cast<uint64_t>(n) * static_cast<uint32_t>(kZoneTables.inverse_power_q30[k + 1]);
    const auto beyond = static_cast<uint32_t>(v_q31 >> kScaleBits);  // v < 2^42
    const int down = beyond == 0 ? 0 : 32 - __builtin_clz(beyond);
    z.scale_v = static_cast<int16_t>(v_q31 >> down);
    z.scale_u = static_cast<int16_t>(u_q31 >> down);
    z.shift = static_cast<int16_t>(31 - down);
    z.origin_v_q16 = static_cast<int32_t>(v_q31 >> 15) - (kZoneTables.inverse_power_q30[k] >> 15);
    z.origin_u_q16 = static_cast<int32_t>(u_q31 >> 15) - (kZoneTables.inverse_power_q30[k + 1] >> 15);
    return z;
}

}  // namespace

LatticeZones::LatticeZones(const Lattice& lattice)
    : size(static_cast<int32_t>(lattice.size())),
      polar_z_q30(lattice.height_at_q30(kPolarHeight << 10)),
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

}  // namespace lumi::detail
