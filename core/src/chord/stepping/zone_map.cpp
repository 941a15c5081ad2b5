// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/stepping/zone_map.h"

#include "chord/stepping/coarse_math.h"
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

// Returns the scale of the polar pattern's plane at height z: sqrt(n/(2·(1 + |z|))), Q7.
int32_t plane_scale_q7(int32_t n, int32_t z_q30)
{
    const uint32_t z_q15 = static_cast<uint32_t>(magnitude(z_q30)) >> 15;
    const CoarseReciprocal r = coarse_reciprocal(2 * (32768 + z_q15));  // about 2^17
    // n/(2(1 + |z|)) < 2^15 in Q14, whose root is Q7 where coarse_root_q15 takes Q30 to Q15.
    const uint32_t scale2_q14 = (static_cast<uint32_t>(n) * static_cast<uint32_t>(r.mantissa)) >> (r.exponent - 29);
    return coarse_root_q15(scale2_q14);
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

void ZoneMap::choose(int32_t z_q30, CellLine& line)
{
    LUMI_TALLY(Work::zone, 1);
    const int32_t height = z_q30 < 0 ? -z_q30 : z_q30;
    while (zone_ > 0 && height >= zones_.zone[zone_].begin_z_q30) --zone_;
    while (zone_ + 1 < kSpanZones && height < zones_.zone[zone_ + 1].begin_z_q30) ++zone_;
    const Zone& z = zones_.zone[zone_];
    const int32_t first = kFibonacci[kFirstSpanZone + zone_];
    const int32_t second = kFibonacci[kFirstSpanZone + zone_ + 1];
    const bool mirrored = z_q30 < 0;
    const bool acute = height >= z.obtuse_z_q30;
    const int32_t odd = ((zone_ + kFirstSpanZone) & 1) != 0 ? 1 : -1;
    const int32_t hemisphere = mirrored ? -1 : 1;
    const int32_t reflection = acute ? -1 : 1;

    line.zone = &z;
    shift_ = z.shift;
    u_longitude_ = reflection * odd * hemisphere * second;
    v_longitude_ = -odd * hemisphere * first;
    u_z_ = -reflection * hemisphere * z.scale_u;
    v_z_ = -hemisphere * z.scale_v;
    u_q16_ = reflection * z.origin_u_q16;
    v_q16_ = z.origin_v_q16;
    if (mirrored) {
        u_q16_ += reflection * odd * ((second * zones_.mirror_turns20) >> 4);
        v_q16_ -= odd * ((first * zones_.mirror_turns20) >> 4);
    }
    line.first = reflection * hemisphere * first;
    line.second = hemisphere * second;
    line.base = mirrored ? zones_.size - 1 : 0;

    // A corner of this hemisphere's cells lies `half` below its cell's middle.
    const int32_t half_q10 = 512 * (acute ? second - first : first + second);
    const int32_t limit = (z.obtuse_index_q10 - half_q10 + 1023) >> 10;
    line.flip = mirrored ? 1 - limit : limit;
    line.flip_mask = mirrored != acute ? -1 : 0;
    set_borders(z, mirrored, acute, first, second);
}

// |z| where `points` and one more lie between a point and the pole.
int32_t ZoneMap::pole_distance_z_q30(int32_t points) const
{
    return kOneQ30 - (2 * (points + 1) + 1) * zones_.step_z_q30;
}

void ZoneMap::set_borders(const Zone& z, bool mirrored, bool acute, int32_t first, int32_t second)
{
    // The middle of a cell lies within (first + second)/2 indices of any point of it, (first + second)/n in height; an
    // eighth more, as tiles and spans are moved.
    const int32_t reach = (first + second) * zones_.step_z_q30;
    const int32_t margin = reach + reach / 8;
    const int32_t border_z = z.number == kPolarZone ? pole_distance_z_q30(kObtuseHeight - 1) : z.obtuse_z_q30;
    const int32_t uniform_low = acute && border_z != 0 ? border_z + margin : -kOneQ30;
    const int32_t uniform_high = acute ? kOneQ30 : border_z - margin;
    uniform_low_z_q30_ = mirrored ? -uniform_high : uniform_low;
    uniform_high_z_q30_ = mirrored ? -uniform_low : uniform_high;

    const int32_t next_begin = zone_ + 1 < kSpanZones ? zones_.zone[zone_ + 1].begin_z_q30 : 0;
    const int32_t low = acute ? z.obtuse_z_q30 : next_begin;
    const int32_t zone_high = acute ? z.begin_z_q30 : z.obtuse_z_q30;
    const int32_t high = zone_high <= zones_.polar_z_q30 ? zone_high : zones_.polar_z_q30 + 1;
    low_z_q30_ = mirrored ? 1 - high : low;
    high_z_q30_ = mirrored ? 1 - low : high;
    // Corners lie up to both steps from a point of the cell where cells may be flipped or the angle is obtuse, else up
    // to the second one: near the own pole of an acute map, and all over it where no height is obtuse.
    const int32_t most = first + second;
    const int32_t own_z = pole_distance_z_q30(acute ? second : most);
    const int32_t far_z = pole_distance_z_q30(acute && border_z == 0 ? second : most);
    lowest_z_q30_ = mirrored ? -own_z : -far_z;
    highest_z_q30_ = mirrored ? far_z : own_z;
}

LatticePoint LatticeTrack::in_plane(const HitPair& pair, bool mirrored) const
{
    const LatticeZones& zones = map.zones();
    const Hit& at = pair.*hit;
    const int32_t scale_q7 = plane_scale_q7(zones.size, at.z_q30);
    const int32_t x = (at.x_q15 * pair.inverse_mantissa) >> pair.shift;
    const int32_t y = (at.y_q15 * pair.inverse_mantissa) >> pair.shift;
    const int32_t north_x = mirrored ? (x * zones.mirror_cos_q15 + y * zones.mirror_sin_q15) >> 15 : x;
    const int32_t north_y = mirrored ? (x * zones.mirror_sin_q15 - y * zones.mirror_cos_q15) >> 15 : y;
    return {(north_x * scale_q7) >> 6, (north_y * scale_q7) >> 6};
}

void LatticeTrack::enter_pole(bool mirrored)
{
    map.leave();
    line.over_pole = true;
    line.polar.triangle = 0;  // a scanline's picture must not depend on those before it
    line.polar.step = mirrored ? -1 : 1;
    line.polar.base = mirrored ? map.zones().size - 1 : 0;
}

void LatticeTrack::set_polar(const LatticePoint& from, const LatticePoint& step_q16)
{
    line.polar.x_q12 = from.u_q16 >> 4;
    line.polar.y_q12 = from.v_q16 >> 4;
    line.polar.dx_q16 = step_q16.u_q16;
    line.polar.dy_q16 = step_q16.v_q16;
    line.polar.find(0);
}

}  // namespace lumi::detail
