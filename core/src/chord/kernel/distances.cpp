// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/kernel/distances.h"

#include "math/generate.h"

namespace lumi::detail
{
namespace
{

// Shapes from 0.875 to 2.875 in 32 parts.
constexpr int kShapes = 32;
constexpr int32_t kFirstShapeQ12 = 3584;
constexpr int kShapeLog2 = 8;

struct Shape {
    int16_t n_q13;        // n of the zone's first step
    int16_t inverse_q14;  // 1/X
};

// A shape's shorter step and its longer one, Q13: e of both and n of both in halves, then e and n of each one.
struct Steps {
    int32_t e, n, shorter, longer;
};

// A zone's constants, for every size of a lattice.
struct ZoneShape {
    uint16_t mantissa;  // 2·√5·π/Φ^2k as mantissa·2^-(15 + 4 + shift)
    int16_t shift;
    int32_t reach_q4;  // Φ^2k/(2·√5·π)
    int32_t bend_q15;  // 2·π·√5/Φ^k
};

struct Tables {
    Shape shape[kShapes];
    Steps steps[2][kShapes];  // as they are, and mirrored
    ZoneShape zone[kSpanZones];
};

constexpr int32_t round_q13(double v)
{
    return static_cast<int32_t>(v * 8192 + (v < 0 ? -0.5 : 0.5));
}

constexpr int32_t pack(int32_t low, int32_t high)
{
    return static_cast<int32_t>((static_cast<uint32_t>(high) << 16) | (static_cast<uint32_t>(low) & 0xFFFFu));
}

constexpr Steps make_steps(int32_t short_e, int32_t short_n, int32_t long_e, int32_t long_n)
{
    return {pack(short_e, long_e), pack(short_n, long_n), 65536 * short_n + short_e, 65536 * long_n + long_e};
}

constexpr Tables make_tables()
{
    Tables t{};
    const double root5 = generate::root(5);
    for (int k = 0; k < kShapes; ++k) {
        const double x = (kFirstShapeQ12 + (k + 0.5) * (1 << kShapeLog2)) / 4096;
        const double e = generate::root(x / root5);
        const double n = 1 / generate::root(x * root5);
        const int32_t second_e = round_q13(-e / generate::kGolden);
        const int32_t second_n = round_q13(n * generate::kGolden);
        t.shape[k] = {static_cast<int16_t>(round_q13(n)), static_cast<int16_t>(16384 / x + 0.5)};
        t.steps[0][k] = make_steps(second_e, second_n, round_q13(e), round_q13(n));
        t.steps[1][k] = make_steps(-round_q13(e), -round_q13(n), second_e, second_n);
    }
    double power = 1;
    for (int k = 0; k < kFirstSpanZone; ++k) power *= generate::kGolden;
    for (ZoneShape& z : t.zone) {
        const double per_index = 2 * root5 * generate::kPi / (power * power);
        double mantissa = per_index * (1 << 19);
        int shift = 0;
        for (; mantissa < 22000; mantissa *= 2) ++shift;
        z = {static_cast<uint16_t>(mantissa + 0.5), static_cast<int16_t>(shift),
             static_cast<int32_t>(16 / per_index + 0.5),
             static_cast<int32_t>(32768 * 2 * generate::kPi * root5 / power + 0.5)};
        power *= generate::kGolden;
    }
    return t;
}

constexpr Tables kTables = make_tables();

constexpr int32_t clamped(int32_t v, int32_t low, int32_t high)
{
    return v < low ? low : v > high ? high : v;
}

uint32_t fraction_q12(int32_t q16)
{
    return (static_cast<uint32_t>(q16) >> 4) & 0xFFFu;
}

int32_t rounded_q12(int32_t q16)
{
    return (q16 + 8) >> 4;
}

}  // namespace

SpanDistances::SpanDistances(const CellLine& side, const Lattice& lattice, int32_t unit, int32_t from, int32_t length)
{
    const int32_t u_q16 = side.u_q16 + from * side.du_q16;
    const int32_t v_q16 = side.v_q16 + from * side.dv_q16;
    const int32_t first = side.first * unit;
    const int32_t second = side.second * unit;
    base_ = side.base * unit + first * (u_q16 >> 16) + second * (v_q16 >> 16);
    last_ = static_cast<int32_t>(lattice.size() - 1) * unit;
    if (side.reflected()) {
        across_ = first;
        next_strand_ = second;
        at_ = fraction_q12(u_q16) | fraction_q12(v_q16) << 16;
        step_ = static_cast<uint32_t>(joined(rounded_q12(side.du_q16), rounded_q12(side.dv_q16)));
    } else {
        across_ = second;
        next_strand_ = first;
        at_ = fraction_q12(v_q16) | fraction_q12(u_q16) << 16;
        step_ = static_cast<uint32_t>(joined(rounded_q12(side.dv_q16), rounded_q12(side.du_q16)));
    }
    index_ = pack(across_, next_strand_);
    bend(side, lattice, {u_q16, v_q16}, length);
}

// T changes by at most 0.12 over half a stretch, and the shape is taken from the table's range: beyond that distances
// are not right, but no sum overflows.
LUMI_ALWAYS_INLINE void SpanDistances::bend(const CellLine& side, const Lattice& lattice, const LatticePoint& from,
                                            int32_t length)
{
    const ZoneShape& zone = kTables.zone[side.zone->number - kFirstSpanZone];
    const int32_t hemisphere = side.second < 0 ? -1 : 1;
    const int32_t step_q16 = hemisphere * (side.first * side.du_q16 + side.second * side.dv_q16);
    const int32_t way_q9 = (step_q16 >> 7) * (length - 1);
    const int32_t begin_q8 = hemisphere * (side.first * (from.u_q16 >> 8) + side.second * (from.v_q16 >> 8));
    const int32_t middle_q8 = begin_q8 + (way_q9 >> 2);
    // Points lie up to a step across the strands and two along them away; three more for rounding.
    const bool reflected = side.reflected();
    const int32_t first = magnitude(side.first);
    const int32_t second = magnitude(side.second);
    const int32_t reach = (first + second + (reflected ? first : second) + 3) << 8;
    const int32_t nearest_end = middle_q8 - (magnitude(way_q9) >> 2) - reach;
    const int32_t farthest_end = middle_q8 + (magnitude(way_q9) >> 2) + reach;
    is_inside_ = nearest_end >= 0 && farthest_end < static_cast<int32_t>(lattice.size() << 8);

    // With t the index from the own pole: (2t + 1)·2·√5·π/Φ^2k in x, (2t + 1)/n = 1 - |z| in r.
    const int32_t mantissa = zone.mantissa;
    const int32_t x_q12 = (clamped((2 * middle_q8 + 256) >> zone.shift, 0, 32767) * mantissa) >> 15;
    const uint32_t reach_q15 = ((lattice.reciprocal_q30() >> 4) * static_cast<uint32_t>(zone.reach_q4)) >> 15;
    const int32_t r_q15 = clamped((x_q12 * static_cast<int32_t>(reach_q15)) >> 12, 0, 65535);
    const int32_t z_q15 = 32768 - r_q15;
    const int32_t shape_q12 =
        x_q12 - static_cast<int32_t>((static_cast<uint32_t>(x_q12) * static_cast<uint32_t>(r_q15)) >> 16);
    const int32_t within_q12 = clamped(shape_q12 - kFirstShapeQ12, 0, (kShapes << kShapeLog2) - 1);
    const Shape& shape = kTables.shape[within_q12 >> kShapeLog2];

    constexpr int32_t kHalf = 1 << (kShapeLog2 - 1);
    const int32_t off_q16 = (((within_q12 & (2 * kHalf - 1)) - kHalf) * shape.inverse_q14) >> 10;
    const int32_t step_x_q16 = (clamped((step_q16 >> 3) >> zone.shift, -32768, 32767) * mantissa) >> 15;
    const int32_t change_q16 = (((step_x_q16 * z_q15) >> 15) * shape.inverse_q14) >> 14;
    bend_step_q16_ = clamped(change_q16, -1024, 1023);
    bend_q16_ = off_q16 - ((bend_step_q16_ * (length - 1)) >> 1);
    bend_n_q16_ = clamped((((z_q15 * shape.n_q13) >> 13) * zone.bend_q15) >> 14, -16384, 16383);
    const Steps& steps = kTables.steps[reflected ? 1 : 0][within_q12 >> kShapeLog2];
    e_ = steps.e;
    n_ = steps.n;
    short_ = steps.shorter;
    long_ = steps.longer;
    bend_short_ = (bend_n_q16_ * (short_ >> 16)) >> 13;
    bend_long_ = (bend_n_q16_ * (long_ >> 16)) >> 13;
    most_along_q26_ = is_inside_ ? most_along_q26() : 0;
}

uint32_t SpanDistances::most_along_q26() const
{
    return static_cast<uint32_t>(dual_product(short_, short_) + dual_product(short_, long_));
}

int32_t SpanDistances::existing(int32_t corner, int32_t along_q26) const
{
    const int32_t onwards = across_ < 0 ? -1 : 1;
    const auto kept = [&](int32_t offset, int32_t points) {
        const int32_t least = base_ + offset + (across_ < 0 ? across_ : 0);
        const int32_t most = base_ + offset + (across_ < 0 ? 0 : across_);
        while (least + points * across_ < 0) points += onwards;
        while (most + points * across_ > last_) points -= onwards;
        return points;
    };
    const int32_t first = kept(corner, along_q26 < 0 ? -1 : 0);
    const bool behind = along_q26 >= 0 && static_cast<uint32_t>(along_q26) > most_along_q26();
    return pack(first, kept(corner + next_strand_, behind ? 1 : 0));
}

}  // namespace lumi::detail
