// SPDX-License-Identifier: MIT
// Squared distances from a query to the points of the lattice cells around it, from differences in 32-bit products.
//
// With w the way south in height (z - z_i), s the way in longitude and r, r_i the radii of both circles of latitude:
//     d² = w² + (r_i - r)² + r·r_i·4 sin²(s/2)        r_i² - r² = 2·z·w - w²
// No large numbers are subtracted, so 16 bits are enough: within 3/4 spacing, distances are within 1/3000 of a spacing
// of the true ones, for every n from kSmallSize on and every query from kCapHeight on.
#pragma once

#include "lattice/lattice_query.h"

namespace lumi::detail
{

// Nearer to a pole than this real-valued index, longitudes of neighbours differ too much.
inline constexpr int32_t kCapHeight = 8;

class LocalDistances
{
public:
    // From the query to a point. Advances by additions. In units of the lattice, Q14, with 1/2 added for rounding.
    struct Way {
        int32_t index;
        int32_t south_q14;   // w
        int32_t east_q14;    // r·s
        int32_t spread_q14;  // w·z/r, about r_i - r

        Way operator+(const Way& step) const
        {
            return {index + step.index, south_q14 + step.south_q14, east_q14 + step.east_q14,
                    spread_q14 + step.spread_q14};
        }
        Way operator-(const Way& step) const
        {
            return {index - step.index, south_q14 - step.south_q14, east_q14 - step.east_q14,
                    spread_q14 - step.spread_q14};
        }
    };

    LocalDistances(const Lattice& lattice, const Query& query, const Cell& cell);

    // To the cell's lowest corner, and the steps that u and v count.
    const Way& corner() const { return corner_; }
    const Way& first() const { return first_; }
    const Way& second() const { return second_; }

    // In units of Neighbour, of a point within three spacings; UINT32_MAX if it surely is beyond one.
    uint32_t distance2(const Way& way) const;

private:
    Way way(int32_t index, int32_t south_q14, int32_t east_turns32) const;

    int32_t shift_;               // 1/(2r) = inverse_radius·2^-(13 + shift) a unit
    int32_t inverse_radius_q13_;  // [2^13, 2^14]
    uint32_t radius_q16_;         // 2π/8 of the radius' mantissa
    uint32_t slope_q14_;          // of z/r
    int32_t slope_shift_;
    Way corner_, first_, second_;
};

}  // namespace lumi::detail
