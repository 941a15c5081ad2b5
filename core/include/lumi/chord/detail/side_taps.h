// SPDX-License-Identifier: MIT
// The taps of one lattice under a pixel, through cells or over a pole, as points of the lattice: what the loops that
// check every texel are made of. The fast loops through cells take the same taps (both_sides.h).
#pragma once

#include "lumi/chord/detail/stepping/lattice_line.h"
#include "lumi/detail/lattice.h"

namespace lumi::detail
{

// Added to a cell's coordinates before they are rounded down: to the nearest whole ones.
inline constexpr int32_t kHalfCellQ16 = 1 << 15;

// Three points; weights sum to 2^bits.
struct SideTaps {
    int32_t index[3];
    uint32_t weight[3];
};

// Walks a line pixel by pixel.
class SideWalk
{
public:
    explicit SideWalk(LatticeLine& line) : line_(line) {}

    template <int kBits>
    SideTaps taps() const
    {
        return line_.over_pole ? polar_taps<kBits>() : cell_taps<kBits>();
    }

    // The point of the coordinates, rounded to whole ones; over a pole the corner that weighs most.
    int32_t nearest() const
    {
        if (line_.over_pole) return line_.polar.index(heaviest(line_.polar.weight_q16));
        return line_.cells.base + corner(line_.cells.u_q16 + kHalfCellQ16, line_.cells.v_q16 + kHalfCellQ16);
    }

    void advance()
    {
        ++pixel_;
        if (line_.over_pole) return line_.polar.advance(pixel_);
        line_.cells.u_q16 += line_.cells.du_q16;
        line_.cells.v_q16 += line_.cells.dv_q16;
    }

private:
    static int heaviest(const int32_t (&weight_q16)[3])
    {
        const int heavier = weight_q16[1] > weight_q16[0] ? 1 : 0;
        return weight_q16[2] > weight_q16[heavier] ? 2 : heavier;
    }

    int32_t corner(int32_t u_q16, int32_t v_q16) const
    {
        return line_.cells.first * (u_q16 >> 16) + line_.cells.second * (v_q16 >> 16);
    }

    template <int kBits>
    SideTaps cell_taps() const
    {
        constexpr int32_t kOne = 1 << kBits;
        const CellLine& c = line_.cells;
        const int32_t lowest = corner(c.u_q16, c.v_q16);
        const CellTriangle t = CellTriangle::of((c.u_q16 >> (16 - kBits)) & (kOne - 1),
                                                (c.v_q16 >> (16 - kBits)) & (kOne - 1), kOne, c.is_flipped(lowest));
        SideTaps taps;
        for (int k = 0; k < 3; ++k) {
            taps.index[k] = c.base + lowest + t.first[k] * c.first + t.second[k] * c.second;
            taps.weight[k] = static_cast<uint32_t>(t.weight[k]);
        }
        return taps;
    }

    // Weights are rounded so that they do not sum to more than one.
    template <int kBits>
    SideTaps polar_taps() const
    {
        constexpr uint32_t kOne = 1u << kBits;
        constexpr uint32_t kHalf = 1u << (15 - kBits);
        const PolarLine& p = line_.polar;
        const uint32_t second = (static_cast<uint32_t>(p.weight_q16[1]) + kHalf) >> (16 - kBits);
        const uint32_t third = static_cast<uint32_t>(p.weight_q16[2]) >> (16 - kBits);
        const uint32_t first = second + third < kOne ? kOne - second - third : 0;
        return {{p.index(0), p.index(1), p.index(2)}, {first, second, third}};
    }

    LatticeLine& line_;
    int32_t pixel_ = 0;
};

}  // namespace lumi::detail
