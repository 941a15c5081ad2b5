// SPDX-License-Identifier: MIT
// How far the lattice points around a pixel are: distances in the plane of a span's cells, bent as the sphere is.
//
// In a zone the steps F_k and F_k+1 lead (e, n) spacings across and along the meridian, (√X, 1/√X) and (-√X/Φ, Φ/√X),
// all by 5^-1/4, where X = √5·π·n·(1 - z²)/Φ^2k in [1, Φ²] is the zone's shape. A point's squared distance is
// e² + n² with X taken in the middle between pixel and point: (1 + T)·e² + (1 - T)·n², where T is how much larger than
// the stretch's own X it is there. T is linear along the span and in n, so that one form serves up to 16 pixels.
//
// Points one shorter step apart make a strand (a parastichy of phyllotaxis); across the longer step lies the next one.
// The disc of one spacing reaches two strands, and of each the two points around the pixel: what it holds beside these
// four weighs less than 1/80.
#pragma once

#include "lumi/chord/detail/halves.h"
#include "lumi/chord/detail/stepping/zone_map.h"
#include "lumi/chord/field.h"
#include "lumi/detail/register_hints.h"

namespace lumi::detail
{

// Four points near a pixel: two of each strand, the second one `across` further than the first.
struct NearPoints {
    int32_t strand[2];     // offsets from SpanDistances::base()
    int32_t below_q26[4];  // squared distances less one, 0 where they are more; spacings²
};

// Walks one side of a stretch of a span through cells. Offsets count in `unit` bytes or points.
class SpanDistances
{
public:
    static constexpr int32_t kMostPixels = 16;

    SpanDistances() = default;
    // Pixels `from` .. `from + length - 1` of the span, of which is_followed().
    SpanDistances(const CellLine& side, const Lattice& lattice, int32_t unit, int32_t from, int32_t length);

    // Whether coordinates of `length` pixels fit into 16 bits: they reach less than eight cells.
    static bool is_followed(const CellLine& side, int32_t length)
    {
        return magnitude(side.du_q16) * length < 7 << 16 && magnitude(side.dv_q16) * length < 7 << 16;
    }

    int32_t base() const { return base_; }
    int32_t across() const { return across_; }

    LUMI_ALWAYS_INLINE NearPoints near() const
    {
        const uint32_t fraction = at_ & 0x0FFF0FFFu;
        const int32_t corner = dual_product(static_cast<int32_t>(at_ & 0xF000F000u), index_) >> 12;
        const int32_t e_q13 = dual_product(static_cast<int32_t>(fraction), e_) >> 12;
        const int32_t n_q13 = dual_product(static_cast<int32_t>(fraction), n_) >> 12;
        const int32_t position = joined(e_q13, n_q13);
        const int32_t t_q16 = bend_q16_ - ((bend_n_q16_ * n_q13) >> 13);
        Strands strands = {{corner, position, t_q16},
                           {corner + next_strand_, less(position, long_), t_q16 + bend_long_}};
        // How far along the strand the pixel lies from the first point, times E: less than nothing if the point before
        // it is nearer than the second one, beyond E + F if so is the point behind the next strand's two.
        const int32_t along_q26 = dual_product(position, short_);
        if (__builtin_expect(static_cast<uint32_t>(along_q26) > most_along_q26_, false)) {
            if (!is_inside_) {
                const int32_t points = existing(corner, along_q26);
                move(strands.first, static_cast<int16_t>(points));
                move(strands.second, points >> 16);
            } else if (along_q26 < 0) {
                move(strands.first, -1);
            } else {
                move(strands.second, 1);
            }
        }
        const Strand& a = strands.first;
        const Strand& b = strands.second;
        return {{a.offset, b.offset},
                {below_q26(a.e_n, a.t_q16), below_q26(less(a.e_n, short_), a.t_q16 + bend_short_),
                 below_q26(b.e_n, b.t_q16), below_q26(less(b.e_n, short_), b.t_q16 + bend_short_)}};
    }

    void advance()
    {
        at_ += step_;
        bend_q16_ += bend_step_q16_;
    }

private:
    // Two points of a strand: the first one's offset, the way (e, n) from it to the pixel, and T.
    struct Strand {
        int32_t offset, e_n, t_q16;
    };
    struct Strands {
        Strand first, second;
    };

    // Goes on by `points` along a strand.
    LUMI_ALWAYS_INLINE void move(Strand& strand, int32_t points) const
    {
        strand.offset += points * across_;
        strand.e_n = static_cast<int32_t>(static_cast<uint32_t>(strand.e_n) -
                                          static_cast<uint32_t>(points) * static_cast<uint32_t>(short_));
        strand.t_q16 += points * bend_short_;
    }
    // Next to a pole, where a strand may have ended: how far both are to be moved, in halves.
    int32_t existing(int32_t corner, int32_t along_q26) const;
    uint32_t most_along_q26() const;

    // Two halves whose words may be added: a lower one below zero takes one from the upper one.
    static int32_t joined(int32_t low, int32_t high)
    {
        return static_cast<int32_t>((static_cast<uint32_t>(high) << 16) + static_cast<uint32_t>(low));
    }

    static int32_t less(int32_t a, int32_t b)
    {
        return static_cast<int32_t>(static_cast<uint32_t>(a) - static_cast<uint32_t>(b));
    }

    // (1 + T)·e² + (1 - T)·n² - 1 of e and n, Q13, where it is below zero.
    LUMI_ALWAYS_INLINE static int32_t below_q26(int32_t e_n, int32_t t_q16)
    {
        constexpr int32_t kRounding = 1 << 15;  // rounds the upper half, which is squared
        const int32_t d =
            add_product_top_bottom(dual_difference(e_n, e_n), t_q16, add_dual_product(e_n, e_n, kRounding - (1 << 26)));
        return d & (d >> 31);
    }

    void bend(const CellLine& side, const Lattice& lattice, const LatticePoint& from, int32_t length);

    uint32_t at_, step_;  // halves: along the shorter step, along the longer one; cells, Q12
    int32_t base_, index_, across_, next_strand_;
    int32_t last_;             // the highest offset of all points from the first one
    int32_t e_, n_;            // e and n of the shorter step and of the longer one, in halves, Q13
    uint32_t most_along_q26_;  // E + F, or 0 where not all points exist
    int32_t short_, long_;     // the same numbers by step: e and n of each, in halves
    int32_t bend_q16_, bend_step_q16_, bend_n_q16_;  // T at the pixel, and how it falls along n
    int32_t bend_short_, bend_long_;
    bool is_inside_;  // all points near the stretch exist
};

}  // namespace lumi::detail
