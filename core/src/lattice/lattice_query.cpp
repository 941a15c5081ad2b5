// SPDX-License-Identifier: MIT
#include "lattice/lattice_query.h"

#include "lattice/zone_tables.h"
#include "lumi/detail/math.h"

namespace lumi::detail
{
namespace
{

int32_t clamp_q30(int32_t v)
{
    return v > kOneQ30 ? kOneQ30 : v < -kOneQ30 ? -kOneQ30 : v;
}

// Returns n·(1 - z²) at the real-valued index t, Q10: (2t + 1)·(1 + z) with z >= 0.
uint32_t n_sine2_q10(int32_t height_q10, int32_t z_q30)
{
    const uint64_t twice = static_cast<uint64_t>(2 * static_cast<int64_t>(height_q10) + 1024);
    return static_cast<uint32_t>((twice * (static_cast<uint32_t>(z_q30) + static_cast<uint32_t>(kOneQ30))) >> 30);
}

// Keinert's zone: the k with Φ^2k <= √5·π·n·(1 - z²) < Φ^(2k+2), where F_k and F_k+1 are the shortest steps.
int zone_of(const Query& q)
{
    const uint32_t n_sine2 = n_sine2_q10(q.height_q10, q.z_q30);
    int k = 1;
    while (k + 1 < kZones && n_sine2 >= kZoneTables.threshold_q10[2 * (k + 1)]) ++k;
    LUMI_TALLY(Work::zone_step, k);
    return k;
}

}  // namespace

Query make_query(const Lattice& lattice, const Vec3q30& d)
{
    const uint32_t longitude = angle_turns32(d.y, d.x);
    const int32_t z = clamp_q30(d.z);
    if (z >= 0) return {longitude, lattice.index_at_q10(z), z, false};
    return {longitude_turns32(lattice.size() - 1) - longitude, lattice.index_at_q10(-z), -z, true};
}

Cell cell_of(const Query& q)
{
    const int k = zone_of(q);
    const int32_t first = kFibonacci[k];
    const int32_t second = kFibonacci[k + 1];
    // (longitude · F) >> 20 by halves: a 64-bit product is a library call on a Cortex-M0+.
    const auto along_longitude = [&](int32_t fibonacci) {
        const auto f = static_cast<uint32_t>(fibonacci);
        const auto way = static_cast<int32_t>(
            ((q.longitude_turns32 >> 16) * f + (((q.longitude_turns32 & 0xFFFFu) * f) >> 16)) >> 4);
        return (k & 1) != 0 ? way : -way;
    };
    const auto along_height = [&](int32_t step_q30) { return (static_cast<int64_t>(q.height_q10) * step_q30) >> 28; };
    return {k, first, second,
            static_cast<int32_t>(along_longitude(second) + along_height(kZoneTables.inverse_power_q30[k + 1])),
            static_cast<int32_t>(along_height(kZoneTables.inverse_power_q30[k]) - along_longitude(first))};
}

bool is_obtuse(const Lattice& lattice, const Cell& cell, int32_t corner)
{
    // A cell over the equator is the same cell from both hemispheres: its middle counts from the nearer pole.
    const int32_t from_here_q10 = 1024 * corner + 512 * (cell.first + cell.second);
    const int32_t from_there_q10 = (static_cast<int32_t>(lattice.size()) - 1) * 1024 - from_here_q10;
    const int32_t middle_q10 = from_here_q10 < from_there_q10 ? from_here_q10 : from_there_q10;
    if (cell.zone == kPolarZone) return middle_q10 >= kObtuseHeight << 10;
    const int32_t z_q30 = lattice.height_at_q30(middle_q10);
    return n_sine2_q10(middle_q10, z_q30) >= kZoneTables.threshold_q10[2 * cell.zone + 1];
}

}  // namespace lumi::detail
