// SPDX-License-Identifier: MIT
// Where a pixel's own exact hit lies in the coordinates that a span or a tile is drawn with.
#pragma once

#include <cmath>

#include "lumi/chord/detail/stepping/zone_map.h"

namespace lumi::test
{

// A pixel's coordinates in the map that a track is in, from its own hit.
inline detail::LatticePoint own_place(const detail::LatticeTrack& track, const detail::HitPair& pair,
                                      const detail::LatticePoint& near)
{
    const detail::Hit& hit = pair.*track.hit;
    // Longitudes wrap: of the three turns that of the nearest place is meant.
    detail::LatticePoint best{};
    double least = 1e9;
    for (int32_t turn = -1; turn <= 1; ++turn) {
        const int32_t longitude_q20 = static_cast<int32_t>(hit.longitude_turns32 >> 12) + turn * (1 << 20);
        const detail::LatticePoint p = track.map.at(longitude_q20, hit.z_q30 >> 14);
        const double off = std::abs(static_cast<double>(p.u_q16) - near.u_q16);
        if (off < least) {
            least = off;
            best = p;
        }
    }
    return best;
}

}  // namespace lumi::test
