// SPDX-License-Identifier: MIT
#include "lumi/span_lattice.h"

#include "generate.h"
#include "lumi/math.h"

namespace lumi
{
namespace
{

constexpr int32_t kFibonacci[kFirstSpanZone + kSpanZones + 1] = {0,  1,  1,  2,  3,   5,   8,   13,
                                                                 21, 34, 55, 89, 144, 233, 377, 610};

struct PowerTables {
    int32_t inverse_q30[kFirstSpanZone + kSpanZones + 1];      // Φ^-k
    uint64_t zone_q30[2 * (kFirstSpanZone + kSpanZones) + 1];  // Φ^m/(√5·π)
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
    for (uint64_t& v : t.zone_q30) {
        v = static_cast<uint64_t>(kOneQ30 * power);
        power *= generate::kGolden;
    }
    return t;
}

constexpr PowerTables kPowers = make_tables();

constexpr int kScaleBits = 14;

uint32_t saturated(uint64_t v)
{
    return v > UINT32_MAX ? UINT32_MAX : static_cast<uint32_t>(v);
}

SpanZone make_zone(const Lattice& lattice, int k)
{
    const uint32_t n = lattice.size();
    SpanZone z{};
    z.first = kFibonacci[k];
    z.second = kFibonacci[k + 1];
    z.begin_q30 = saturated(kPowers.zone_q30[2 * k] / n);
    z.obtuse_q30 = saturated(kPowers.zone_q30[2 * k + 1] / n);
    const uint32_t low = static_cast<uint32_t>(z.first + z.second) + 1;
    z.low_q30 =
        low < n ? static_cast<uint32_t>(kOneQ30 - lattice.height_at_q30(static_cast<int32_t>(low << 10))) : UINT32_MAX;
    // v = Φ^-k·n/2·(1 - |z|) - Φ^-k/2: heights come in Q16, coordinates leave in Q16.
    const uint64_t v_q31 = static_cast<uint64_t>(n) * static_cast<uint32_t>(kPowers.inverse_q30[k]);
    const uint64_t u_q31 = static_cast<uint64_t>(n) * static_cast<uint32_t>(kPowers.inverse_q30[k + 1]);
    int down = 0;
    while ((v_q31 >> down) >= uint64_t{1} << kScaleBits) ++down;
    z.scale_v = static_cast<int32_t>(v_q31 >> down);
    z.scale_u = static_cast<int32_t>(u_q31 >> down);
    z.shift = 31 - down;
    z.origin_v_q16 = kPowers.inverse_q30[k] >> 15;
    z.origin_u_q16 = kPowers.inverse_q30[k + 1] >> 15;
    return z;
}

uint32_t distance_from_pole_q30(int32_t z_q30)
{
    const uint32_t magnitude = static_cast<uint32_t>(z_q30 < 0 ? -z_q30 : z_q30);
    return magnitude < static_cast<uint32_t>(kOneQ30) ? static_cast<uint32_t>(kOneQ30) - magnitude : 0;
}

uint32_t sine2_q30(int32_t z_q30)
{
    const int32_t z_q15 = z_q30 >> 15;
    const uint32_t z2 = static_cast<uint32_t>(z_q15 * z_q15);
    return z2 < static_cast<uint32_t>(kOneQ30) ? static_cast<uint32_t>(kOneQ30) - z2 : 0;
}

constexpr int32_t kMaxTurnQ20 = 1 << 16;  // 1/16 turn

}  // namespace

SpanLattice::SpanLattice(const Lattice& lattice)
    : size(lattice.size()),
      mirror_turns32(longitude_turns32(lattice.size() - 1)),
      cap_q30(static_cast<uint32_t>(kOneQ30 - lattice.height_at_q30(kSpanCapHeight << 10)))
{
    for (int k = 0; k < kSpanZones; ++k) zone[k] = make_zone(lattice, kFirstSpanZone + k);
}

int32_t SpanSide::highest(int32_t length) const
{
    const auto index = [&](int32_t u, int32_t v) { return base + first * (u >> 16) + second * (v >> 16); };
    const int32_t a = index(u_q16, v_q16);
    const int32_t b = index(u_q16 + length * du_q16, v_q16 + length * dv_q16);
    // A floor takes up to one step off either coordinate, and a cell's corners lie up to both steps on.
    return (a > b ? a : b) + 2 * (zone->first + zone->second);
}

void SpanWalker::begin(const SpanHit& hit)
{
    longitude_turns32_ = hit.longitude_turns32;
    at_ = {static_cast<int32_t>(hit.longitude_turns32 >> 12), hit.z_q30};
    known_ = false;
}

int SpanWalker::zone_at(uint32_t sine2) const
{
    int k = zone_;
    while (k > 0 && sine2 < lattice_.zone[k].begin_q30) --k;
    while (k + 1 < kSpanZones && sine2 >= lattice_.zone[k + 1].begin_q30) ++k;
    return k;
}

void SpanWalker::coordinates(const Position& p, int32_t& u_q16, int32_t& v_q16) const
{
    const SpanZone& z = lattice_.zone[zone_];
    const int32_t z_q30 = mirrored_ ? -p.z_q30 : p.z_q30;
    const int32_t height_q16 = static_cast<int32_t>(static_cast<uint32_t>(kOneQ30 - z_q30) >> 14);
    const int32_t longitude =
        mirrored_ ? static_cast<int32_t>(lattice_.mirror_turns32 >> 12) - p.longitude_q20 : p.longitude_q20;
    const bool odd = ((zone_ + kFirstSpanZone) & 1) != 0;
    const int32_t along_u = (z.second * longitude) >> 4;
    const int32_t along_v = (z.first * longitude) >> 4;
    const int32_t up_u = ((height_q16 * z.scale_u) >> z.shift) - z.origin_u_q16;
    const int32_t up_v = ((height_q16 * z.scale_v) >> z.shift) - z.origin_v_q16;
    u_q16 = odd ? up_u + along_u : up_u - along_u;
    v_q16 = odd ? up_v - along_v : up_v + along_v;
}

bool SpanWalker::advance(const SpanHit& next, int length_log2, SpanSide& out)
{
    const int32_t turn_q20 = static_cast<int32_t>(next.longitude_turns32 - longitude_turns32_) >> 12;
    const Position from = at_;
    longitude_turns32_ = next.longitude_turns32;
    at_ = {from.longitude_q20 + turn_q20, next.z_q30};
    const uint32_t from_pole = distance_from_pole_q30(from.z_q30);
    const uint32_t next_pole = distance_from_pole_q30(next.z_q30);
    const uint32_t closest = from_pole < next_pole ? from_pole : next_pole;
    if (closest < lattice_.cap_q30 || turn_q20 > kMaxTurnQ20 || turn_q20 < -kMaxTurnQ20) {
        known_ = false;
        return false;
    }
    const int32_t middle_z = (from.z_q30 >> 1) + (next.z_q30 >> 1);
    const uint32_t sine2 = sine2_q30(middle_z);
    const int zone = zone_at(sine2);
    const bool mirrored = middle_z < 0;
    if (closest < lattice_.zone[zone].low_q30) {
        known_ = false;
        return false;
    }
    if (!known_ || zone != zone_ || mirrored != mirrored_) {
        zone_ = zone;
        mirrored_ = mirrored;
        coordinates(from, u_q16_, v_q16_);
    }
    const int32_t u = u_q16_;
    const int32_t v = v_q16_;
    coordinates(at_, u_q16_, v_q16_);
    known_ = true;

    const SpanZone& z = lattice_.zone[zone];
    const bool acute = sine2 < z.obtuse_q30;
    const int32_t first = mirrored ? -z.first : z.first;
    out.zone = &z;
    out.sine2_q30 = sine2;
    out.u_q16 = acute ? -u : u;
    out.v_q16 = v;
    out.du_q16 = (acute ? u - u_q16_ : u_q16_ - u) >> length_log2;
    out.dv_q16 = (v_q16_ - v) >> length_log2;
    out.first = acute ? -first : first;
    out.second = mirrored ? -z.second : z.second;
    out.base = mirrored ? static_cast<int32_t>(lattice_.size) - 1 : 0;
    return true;
}

}  // namespace lumi
