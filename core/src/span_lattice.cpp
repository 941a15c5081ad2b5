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

// 1 - z of a real-valued index; beyond the last point nothing is.
uint32_t from_pole_q30(const Lattice& lattice, int32_t index)
{
    if (static_cast<uint32_t>(index) >= lattice.size()) return UINT32_MAX;
    return static_cast<uint32_t>(kOneQ30 - lattice.height_at_q30(index << 10));
}

SpanZone make_zone(const Lattice& lattice, int k)
{
    const uint32_t n = lattice.size();
    SpanZone z{};
    z.first = kFibonacci[k];
    z.second = kFibonacci[k + 1];
    z.begin_q30 = saturated(kPowers.zone_q30[2 * k] / n);
    z.obtuse_q30 = saturated(kPowers.zone_q30[2 * k + 1] / n);
    z.low_acute_q30 = from_pole_q30(lattice, z.second + 1);
    z.low_obtuse_q30 = from_pole_q30(lattice, z.first + z.second + 1);
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

// The scale of the polar pattern's plane at height z: sqrt(n/(2·(1 + |z|))), Q7.
int32_t plane_scale_q7(uint32_t n, int32_t z_q30)
{
    const uint32_t z_q15 = static_cast<uint32_t>(z_q30 < 0 ? -z_q30 : z_q30) >> 15;
    const CoarseReciprocal r = coarse_reciprocal(2 * (32768 + z_q15));  // about 2^17
    // n/(2(1 + |z|)) < 2^15 in Q14, whose root is Q7 where coarse_root_q15 takes Q30 to Q15.
    const uint32_t scale2_q14 = (n * static_cast<uint32_t>(r.mantissa)) >> (r.exponent - 29);
    return coarse_root_q15(scale2_q14);
}

constexpr int32_t kMaxTurnQ20 = 1 << 16;  // 1/16 turn

}  // namespace

SpanLattice::SpanLattice(const Lattice& lattice)
    : size(lattice.size()),
      mirror_turns32(longitude_turns32(lattice.size() - 1)),
      cap_q30(from_pole_q30(lattice, kSpanCapHeight))
{
    const SinCos mirror = sin_cos(mirror_turns32);
    mirror_cos_q15 = mirror.cos_q30 >> 15;
    mirror_sin_q15 = mirror.sin_q30 >> 15;
    for (int k = 0; k < kSpanZones; ++k) zone[k] = make_zone(lattice, kFirstSpanZone + k);
}

int32_t SpanSide::highest(int32_t length) const
{
    if (in_cap) return first > 0 ? 2 * kSpanCapHeight : base;
    const auto index = [&](int32_t u, int32_t v) { return base + first * (u >> 16) + second * (v >> 16); };
    const int32_t a = index(u_q16, v_q16);
    const int32_t b = index(u_q16 + length * du_q16, v_q16 + length * dv_q16);
    // A floor takes up to one step off either coordinate, and a cell's corners lie up to both steps on.
    return (a > b ? a : b) + 2 * (zone->first + zone->second);
}

SpanWalker::Position SpanWalker::position(const SpanHit& hit, int32_t longitude_q20) const
{
    return {hit, longitude_q20, distance_from_pole_q30(hit.z_q30), 0, 0};
}

void SpanWalker::begin(const SpanHit& hit)
{
    at_ = position(hit, static_cast<int32_t>(hit.longitude_turns32 >> 12));
    known_ = false;
}

int SpanWalker::zone_at(uint32_t sine2) const
{
    int k = zone_;
    while (k > 0 && sine2 < lattice_.zone[k].begin_q30) --k;
    while (k + 1 < kSpanZones && sine2 >= lattice_.zone[k + 1].begin_q30) ++k;
    return k;
}

void SpanWalker::set_coordinates(Position& p) const
{
    const SpanZone& z = lattice_.zone[zone_];
    const int32_t z_q30 = mirrored_ ? -p.hit.z_q30 : p.hit.z_q30;
    const int32_t height_q16 = static_cast<int32_t>(static_cast<uint32_t>(kOneQ30 - z_q30) >> 14);
    const int32_t longitude =
        mirrored_ ? static_cast<int32_t>(lattice_.mirror_turns32 >> 12) - p.longitude_q20 : p.longitude_q20;
    const bool odd = ((zone_ + kFirstSpanZone) & 1) != 0;
    const int32_t along_u = (z.second * longitude) >> 4;
    const int32_t along_v = (z.first * longitude) >> 4;
    const int32_t up_u = ((height_q16 * z.scale_u) >> z.shift) - z.origin_u_q16;
    const int32_t up_v = ((height_q16 * z.scale_v) >> z.shift) - z.origin_v_q16;
    p.u_q16 = odd ? up_u + along_u : up_u - along_u;
    p.v_q16 = odd ? up_v - along_v : up_v + along_v;
}

bool SpanWalker::prepare(const SpanHit& next, int length_log2, SpanSide& out)
{
    const int32_t turn_q20 = static_cast<int32_t>(next.longitude_turns32 - at_.hit.longitude_turns32) >> 12;
    next_ = position(next, at_.longitude_q20 + turn_q20);
    const bool in_cap = at_.from_pole_q30 < lattice_.cap_q30;
    if (in_cap != (next_.from_pole_q30 < lattice_.cap_q30)) return false;
    if (in_cap) {
        if ((at_.hit.z_q30 ^ next.z_q30) < 0) return false;
        prepare_cap(length_log2, out);
        return true;
    }
    if (turn_q20 > kMaxTurnQ20 || turn_q20 < -kMaxTurnQ20) return false;
    const int32_t middle_z = (at_.hit.z_q30 >> 1) + (next.z_q30 >> 1);
    const uint32_t sine2 = sine2_q30(middle_z);
    const int zone = zone_at(sine2);
    const uint32_t closest = at_.from_pole_q30 < next_.from_pole_q30 ? at_.from_pole_q30 : next_.from_pole_q30;
    const SpanZone& z = lattice_.zone[zone];
    if (closest < (sine2 < z.obtuse_q30 ? z.low_acute_q30 : z.low_obtuse_q30)) return false;
    const bool mirrored = middle_z < 0;
    if (!known_ || zone != zone_ || mirrored != mirrored_) {
        zone_ = zone;
        mirrored_ = mirrored;
        set_coordinates(at_);
        known_ = true;
    }
    set_coordinates(next_);
    out.sine2_q30 = sine2;
    prepare_chart(length_log2, out);
    return true;
}

void SpanWalker::commit()
{
    at_ = next_;
    known_ = known_ && at_.from_pole_q30 >= lattice_.cap_q30;
}

void SpanWalker::prepare_chart(int length_log2, SpanSide& out)
{
    const SpanZone& z = lattice_.zone[zone_];
    const bool acute = out.sine2_q30 < z.obtuse_q30;
    const int32_t first = mirrored_ ? -z.first : z.first;
    const int32_t du = (next_.u_q16 - at_.u_q16) >> length_log2;
    out.in_cap = false;
    out.zone = &z;
    out.u_q16 = acute ? -at_.u_q16 : at_.u_q16;
    out.v_q16 = at_.v_q16;
    out.du_q16 = acute ? -du : du;
    out.dv_q16 = (next_.v_q16 - at_.v_q16) >> length_log2;
    out.first = acute ? -first : first;
    out.second = mirrored_ ? -z.second : z.second;
    out.base = mirrored_ ? static_cast<int32_t>(lattice_.size) - 1 : 0;
}

void SpanWalker::prepare_cap(int length_log2, SpanSide& out) const
{
    const bool mirrored = at_.hit.z_q30 < 0;
    int32_t x[2];
    int32_t y[2];
    const SpanHit* hits[2] = {&at_.hit, &next_.hit};
    for (int k = 0; k < 2; ++k) {
        const int32_t scale_q7 = plane_scale_q7(lattice_.size, hits[k]->z_q30);
        const int32_t hx = hits[k]->x_q15;
        const int32_t hy = hits[k]->y_q15;
        const int32_t north_x = mirrored ? (hx * lattice_.mirror_cos_q15 + hy * lattice_.mirror_sin_q15) >> 15 : hx;
        const int32_t north_y = mirrored ? (hx * lattice_.mirror_sin_q15 - hy * lattice_.mirror_cos_q15) >> 15 : hy;
        x[k] = (north_x * scale_q7) >> 6;  // Q16
        y[k] = (north_y * scale_q7) >> 6;
    }
    out.in_cap = true;
    out.first = mirrored ? -1 : 1;
    out.second = 0;
    out.base = mirrored ? static_cast<int32_t>(lattice_.size) - 1 : 0;
    out.cap.x_q12 = x[0] >> 4;
    out.cap.y_q12 = y[0] >> 4;
    out.cap.dx_q16 = (x[1] - x[0]) >> length_log2;
    out.cap.dy_q16 = (y[1] - y[0]) >> length_log2;
    out.cap.triangle = 0;
    out.cap.find(0);
}

}  // namespace lumi
