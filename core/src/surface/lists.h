// SPDX-License-Identifier: MIT
// Ways through a frame's lists of triangles (bands.h).
#pragma once

#include "lumi/surface/detail/pieces.h"
#include "surface/bands.h"

namespace lumi::detail
{

inline ListWalk walk_of(const SurfaceFrame& frame, const Target& target)
{
    const uint32_t log2 = frame.memory.band_log2 + frame.samples_log2;
    const int32_t from = target.y + frame.margin, first = from >> log2, last = (from + target.height - 1) >> log2;
    return {first < frame.reach ? 0 : first - frame.reach, first, last, last, kBandLists, kEmptyBand};
}

// The triangle after one in its list, or kEmptyBand.
LUMI_ALWAYS_INLINE uint32_t after(uint32_t triangle, uint32_t link)
{
    return (link & kLinkMask) == triangle ? kEmptyBand : link & kLinkMask;
}

// Sets `triangle`; false after the last.
LUMI_ALWAYS_INLINE bool next_listed(ListWalk& walk, const SurfaceFrame& frame, uint32_t& triangle)
{
    const uint16_t* const links = frame.memory.links;
    while (true) {
        while (walk.triangle != kEmptyBand) {
            triangle = walk.triangle;
            const uint32_t link = links[triangle];
            walk.triangle = after(triangle, link);
            if (walk.band + static_cast<int32_t>(link >> kLinkBits) >= walk.first) return true;
        }
        if (++walk.band > walk.last) {
            if (walk.nearness == 0) return false;
            --walk.nearness;
            walk.band = walk.begin;
        }
        walk.triangle = frame.memory.bands[list_of(static_cast<uint32_t>(walk.band), walk.nearness)];
    }
}

}  // namespace lumi::detail
