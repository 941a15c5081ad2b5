// SPDX-License-Identifier: MIT
// Lists of triangles in SurfaceMemory, ways through them, and the triangles' sides. A band has kBandLists lists, by
// depth. A list holds the first triangle of those that begin in the band's scanlines, a link the next after each, the
// last one itself. A link's upper bits tell how many bands further a triangle reaches.
#pragma once

#include "lumi/surface/detail/pieces.h"

namespace lumi::detail
{

inline constexpr uint16_t kEmptyBand = 0xFFFF;
// Links of triangles that are in no list.
inline constexpr uint16_t kTurnedAway = 0xFFFF;
inline constexpr uint16_t kWithoutSamples = 0xFFFE;  // beside the image or between its scanlines
inline constexpr uint32_t kLinkBits = 13;
inline constexpr uint32_t kLinkMask = (uint32_t{1} << kLinkBits) - 1;
inline constexpr int32_t kBandReach = 7;  // a triangle's bands, at most; 8 would make a link look like those

// The list of a band for triangles so near, below kBandLists.
constexpr uint32_t list_of(uint32_t band, uint32_t nearness)
{
    return band * kBandLists + nearness;
}

// A byte a patch, after the links: the sides that are outlines, those of its second triangle in the upper bits.
inline constexpr uint32_t kSideBits = 4;
inline uint8_t* outline_sides(const SurfaceFrame& frame)
{
    return reinterpret_cast<uint8_t*>(frame.memory.links + 2 * frame.field.patch_count);
}

inline uint32_t outline_sides_of(const SurfaceFrame& frame, uint32_t triangle)
{
    return uint32_t{outline_sides(frame)[triangle >> 1]} >> (kSideBits * (triangle & 1)) & 15u;
}

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
            LUMI_TALLY(Work::link, 1);
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

// Leads from corner to corner, in the triangle's order.
struct Side {
    uint32_t from, to;
};

// One of a triangle's three: of the first (a, b, c) a-b, c-a, b-c, of the second (d, c, b) d-c, b-d, c-b.
LUMI_ALWAYS_INLINE Side side_of(const SurfacePatch& patch, uint32_t triangle, uint32_t k)
{
    constexpr uint8_t kCorners[2][3][2] = {{{0, 1}, {2, 0}, {1, 2}}, {{3, 2}, {1, 3}, {2, 1}}};
    const uint8_t* ends = kCorners[triangle & 1][k];
    return {patch.corner[ends[0]], patch.corner[ends[1]]};
}

}  // namespace lumi::detail
