// SPDX-License-Identifier: MIT
#include "lumi/span_lattice.h"

#include "generate.h"
#include "lumi/math.h"

namespace lumi
{
namespace
{

constexpr int32_t kFibonacci[kFirstSpanZone + kSpanZones + 1] = {0,  1,  1,  2,  3,   5,   8,  13,
                                                                 21, 34, 55, 89, 144, 233, 377};

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

int32_t magnitude(int32_t v)
{
    return v < 0 ? -v : v;
}

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
    z.begin_z_q30 = height_of_q30(kPowers.zone_q10[2 * k], lattice);
    z.obtuse_z_q30 = height_of_q30(kPowers.zone_q10[2 * k + 1], lattice);
    // Where even the equator is acute, no cell is obtuse, not even those whose middle lies beyond the equator.
    z.obtuse_index_q10 = z.obtuse_z_q30 != 0 ? lattice.index_at_q10(z.obtuse_z_q30) : static_cast<int32_t>(n << 10);
    // v = Φ^-k·n/2·(1 - |z|) - Φ^-k/2: z comes in Q16, coordinates leave in Q16.
    const uint64_t v_q31 = static_cast<uint64_t>(n) * static_cast<uint32_t>(kPowers.inverse_q30[k]);
    const uint64_t u_q31 = static_cast<uint64_t>(n) * static_cast<uint32_t>(kPowers.inverse_q30[k + 1]);
    int down = 0;
    while ((v_q31 >> down) >= uint64_t{1} << kScaleBits) ++down;
    z.scale_v = static_cast<int16_t>(v_q31 >> down);
    z.scale_u = static_cast<int16_t>(u_q31 >> down);
    z.shift = static_cast<int16_t>(31 - down);
    z.origin_v_q16 = static_cast<int32_t>(v_q31 >> 15) - (kPowers.inverse_q30[k] >> 15);
    z.origin_u_q16 = static_cast<int32_t>(u_q31 >> 15) - (kPowers.inverse_q30[k + 1] >> 15);
    return z;
}

// The scale of the polar pattern's plane at height z: sqrt(n/(2·(1 + |z|))), Q7.
int32_t plane_scale_q7(int32_t n, int32_t z_q30)
{
    const uint32_t z_q15 = static_cast<uint32_t>(magnitude(z_q30)) >> 15;
    const CoarseReciprocal r = coarse_reciprocal(2 * (32768 + z_q15));  // about 2^17
    // n/(2(1 + |z|)) < 2^15 in Q14, whose root is Q7 where coarse_root_q15 takes Q30 to Q15.
    const uint32_t scale2_q14 = (static_cast<uint32_t>(n) * static_cast<uint32_t>(r.mantissa)) >> (r.exponent - 29);
    return coarse_root_q15(scale2_q14);
}

constexpr int32_t kMaxTurnQ20 = 1 << 16;  // 1/16 turn

}  // namespace

SpanLattice::SpanLattice(const Lattice& lattice)
    : size(static_cast<int32_t>(lattice.size())),
      cap_z_q30(height_of_index_q30(lattice, kSpanCapHeight)),
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
    if (in_cap) return first > 0 ? 2 * kSpanCapHeight : base;
    const auto index = [&](int32_t u, int32_t v) { return base + first * (u >> 16) + second * (v >> 16); };
    const int32_t a = index(u_q16, v_q16);
    const int32_t b = index(u_q16 + length * du_q16, v_q16 + length * dv_q16);
    // A floor takes up to one step off either coordinate, and a cell's corners lie up to both steps on.
    return (a > b ? a : b) + 2 * (magnitude(first) + magnitude(second));
}

namespace
{

// How often a span must be halved until its end, as far as heights are linear along it, does not cross |z| = limit.
int halvings(int32_t from_z, int32_t next_z, int32_t limit_z)
{
    const bool above = magnitude(from_z) > limit_z;
    int count = 1;
    for (int32_t step = (next_z >> 1) - (from_z >> 1); count <= kMaxSpanLog2; ++count, step /= 2) {
        if ((magnitude(from_z + step) > limit_z) == above) break;
    }
    return count;
}

}  // namespace

void SpanWalker::begin(const SpanNode& at)
{
    const SpanHit& hit = at.*hit_;
    longitude_q20_ = static_cast<int32_t>(hit.longitude_turns32 >> 12);
    before_.length_log2 = -1;
    side_.cap.triangle = 0;  // a row's picture must not depend on the rows before it
    if (holds(hit.z_q30)) set_coordinates(longitude_q20_, hit.z_q30, side_.u_q16, side_.v_q16);
}

// Chooses the chart for a hit outside the caps.
void SpanWalker::set_chart(int32_t z_q30)
{
    const int32_t height = magnitude(z_q30);
    while (zone_ > 0 && height >= lattice_.zone[zone_].begin_z_q30) --zone_;
    while (zone_ + 1 < kSpanZones && height < lattice_.zone[zone_ + 1].begin_z_q30) ++zone_;
    const SpanZone& z = lattice_.zone[zone_];
    const int32_t first = kFibonacci[kFirstSpanZone + zone_];
    const int32_t second = kFibonacci[kFirstSpanZone + zone_ + 1];
    const bool mirrored = z_q30 < 0;
    const bool acute = height >= z.obtuse_z_q30;
    const int32_t odd = ((zone_ + kFirstSpanZone) & 1) != 0 ? 1 : -1;
    const int32_t hemisphere = mirrored ? -1 : 1;
    const int32_t reflection = acute ? -1 : 1;

    side_.zone = &z;
    chart_.shift = z.shift;
    chart_.u_longitude = reflection * odd * hemisphere * second;
    chart_.v_longitude = -odd * hemisphere * first;
    chart_.u_z = -reflection * hemisphere * z.scale_u;
    chart_.v_z = -hemisphere * z.scale_v;
    chart_.u_q16 = reflection * z.origin_u_q16;
    chart_.v_q16 = z.origin_v_q16;
    if (mirrored) {
        chart_.u_q16 += reflection * odd * ((second * lattice_.mirror_turns20) >> 4);
        chart_.v_q16 -= odd * ((first * lattice_.mirror_turns20) >> 4);
    }
    side_.first = reflection * hemisphere * first;
    side_.second = hemisphere * second;
    side_.base = mirrored ? lattice_.size - 1 : 0;

    // A corner of this hemisphere's cells lies `half` below its cell's middle.
    const int32_t half_q10 = 512 * (acute ? second - first : first + second);
    const int32_t limit = (z.obtuse_index_q10 - half_q10 + 1023) >> 10;
    side_.flip = mirrored ? 1 - limit : limit;
    side_.flip_mask = mirrored != acute ? -1 : 0;

    // The middle of a cell lies within (first + second)/2 indices of any point of it, (first + second)/n in height; an
    // eighth more for spans that are bent.
    const int32_t reach = (first + second) * lattice_.step_z_q30;
    const int32_t margin = reach + reach / 8;
    const int32_t uniform_low = acute && z.obtuse_z_q30 != 0 ? z.obtuse_z_q30 + margin : -kOneQ30;
    const int32_t uniform_high = acute ? kOneQ30 : z.obtuse_z_q30 - margin;
    uniform_low_z_q30_ = mirrored ? -uniform_high : uniform_low;
    uniform_high_z_q30_ = mirrored ? -uniform_low : uniform_high;

    const int32_t next_begin = zone_ + 1 < kSpanZones ? lattice_.zone[zone_ + 1].begin_z_q30 : 0;
    const int32_t low = acute ? z.obtuse_z_q30 : next_begin;
    const int32_t zone_high = acute ? z.begin_z_q30 : z.obtuse_z_q30;
    const int32_t high = zone_high <= lattice_.cap_z_q30 ? zone_high : lattice_.cap_z_q30 + 1;
    low_z_q30_ = mirrored ? 1 - high : low;
    high_z_q30_ = mirrored ? 1 - low : high;
    // Up to the height of this index no corner of a cell lies beyond the pole.
    const int32_t limit_index = (acute ? second : first + second) + 1;
    limit_z_q30_ = kOneQ30 - (2 * limit_index + 1) * lattice_.step_z_q30;
    set_coordinates(longitude_q20_, z_q30, side_.u_q16, side_.v_q16);
    if (before_.length_log2 >= 0) rechart_before();
}

void SpanWalker::rechart_before()
{
    int32_t u_q16 = 0;
    int32_t v_q16 = 0;
    set_coordinates(before_.longitude_q20, before_.z_q30, u_q16, v_q16);
    before_.du_q16 = (side_.u_q16 - u_q16) >> before_.length_log2;
    before_.dv_q16 = (side_.v_q16 - v_q16) >> before_.length_log2;
}

// With the span's length L and L0 of the one before, the parabola's slopes at a quarter and at three quarters of the
// span differ from the chord's by -+(step - step before)·L/(2·(L + L0)).
bool SpanWalker::bend_longest()
{
    constexpr uint8_t kShare_q5[] = {13, 11, 8};  // L0/L = 1/4, 1/2, 1
    constexpr int32_t kFlatQ16 = 2048;            // a step that changes less is as good as straight: 1/16 of a cell
    const int32_t share_q5 = kShare_q5[before_.length_log2 - (kMaxSpanLog2 - 2)];
    const int32_t ddu = side_.du_q16 - before_.du_q16;
    const int32_t ddv = side_.dv_q16 - before_.dv_q16;
    note(kMaxSpanLog2);
    if (magnitude(ddu) + magnitude(ddv) < kFlatQ16) return false;
    side_.du_q16 -= (ddu * share_q5) >> 5;
    side_.dv_q16 -= (ddv * share_q5) >> 5;
    return true;
}

void SpanWalker::set_coordinates(int32_t longitude_q20, int32_t z_q30, int32_t& u_q16, int32_t& v_q16) const
{
    const int32_t z_q16 = z_q30 >> 14;
    u_q16 = chart_.u_q16 + ((chart_.u_longitude * longitude_q20) >> 4) + ((chart_.u_z * z_q16) >> chart_.shift);
    v_q16 = chart_.v_q16 + ((chart_.v_longitude * longitude_q20) >> 4) + ((chart_.v_z * z_q16) >> chart_.shift);
}

int SpanWalker::prepare(const SpanNode& at_node, const SpanNode& next_node, int length_log2)
{
    const SpanHit& at = at_node.*hit_;
    const SpanHit& next = next_node.*hit_;
    const int32_t next_height = magnitude(next.z_q30);
    const int32_t turn_q20 = static_cast<int32_t>(next.longitude_turns32 - at.longitude_turns32) >> 12;
    next_longitude_q20_ = longitude_q20_ + turn_q20;
    if (!holds(at.z_q30)) {
        if (magnitude(at.z_q30) > lattice_.cap_z_q30) {
            if (next_height <= lattice_.cap_z_q30) return halvings(at.z_q30, next.z_q30, lattice_.cap_z_q30);
            prepare_cap(at_node, next_node, length_log2);
            return 0;
        }
        set_chart(at.z_q30);
    }
    if (next_height > limit_z_q30_) return halvings(at.z_q30, next.z_q30, limit_z_q30_);
    if (static_cast<uint32_t>(turn_q20 + kMaxTurnQ20) > 2 * static_cast<uint32_t>(kMaxTurnQ20)) return 1;
    set_coordinates(next_longitude_q20_, next.z_q30, next_u_q16_, next_v_q16_);
    side_.du_q16 = (next_u_q16_ - side_.u_q16) >> length_log2;
    side_.dv_q16 = (next_v_q16_ - side_.v_q16) >> length_log2;
    side_.z_q30 = at.z_q30;
    side_.in_cap = false;
    const auto is_uniform_at = [&](int32_t z) { return z >= uniform_low_z_q30_ && z <= uniform_high_z_q30_; };
    side_.uniform = is_uniform_at(at.z_q30) && is_uniform_at(next.z_q30);
    return 0;
}

// Leaves the chart behind: the side now counts from the pole.
void SpanWalker::prepare_cap(const SpanNode& at, const SpanNode& next, int length_log2)
{
    const bool mirrored = (at.*hit_).z_q30 < 0;
    const SpanNode* nodes[2] = {&at, &next};
    int32_t x[2];
    int32_t y[2];
    for (int k = 0; k < 2; ++k) {
        const SpanHit& hit = nodes[k]->*hit_;
        const int32_t scale_q7 = plane_scale_q7(lattice_.size, hit.z_q30);
        const int32_t hx = (hit.x_q15 * nodes[k]->inverse_mantissa) >> nodes[k]->shift;
        const int32_t hy = (hit.y_q15 * nodes[k]->inverse_mantissa) >> nodes[k]->shift;
        const int32_t north_x = mirrored ? (hx * lattice_.mirror_cos_q15 + hy * lattice_.mirror_sin_q15) >> 15 : hx;
        const int32_t north_y = mirrored ? (hx * lattice_.mirror_sin_q15 - hy * lattice_.mirror_cos_q15) >> 15 : hy;
        x[k] = (north_x * scale_q7) >> 6;  // Q16
        y[k] = (north_y * scale_q7) >> 6;
    }
    low_z_q30_ = high_z_q30_ = 0;
    side_.in_cap = true;
    side_.first = mirrored ? -1 : 1;
    side_.second = 0;
    side_.base = mirrored ? lattice_.size - 1 : 0;
    side_.cap.x_q12 = x[0] >> 4;
    side_.cap.y_q12 = y[0] >> 4;
    side_.cap.dx_q16 = (x[1] - x[0]) >> length_log2;
    side_.cap.dy_q16 = (y[1] - y[0]) >> length_log2;
    side_.cap.find(0);
}

}  // namespace lumi
