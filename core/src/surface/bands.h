// SPDX-License-Identifier: MIT
// Lists of triangles in SurfaceMemory: a band has kBandLists of them, by depth. A list holds the first triangle of
// those that begin in the band's scanlines, a link the next after each, the last one itself. A link's upper bits tell
// how many bands further a triangle reaches.
#pragma once

#include "lumi/surface/frame.h"

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

// Four bits a triangle, after the links: its sides that are outlines.
inline uint16_t* outline_bits(const SurfaceFrame& frame)
{
    return frame.memory.links + 2 * frame.field.patch_count;
}

inline uint32_t outline_sides(const SurfaceFrame& frame, uint32_t triangle)
{
    return uint32_t{outline_bits(frame)[triangle >> 2]} >> (4 * (triangle & 3)) & 15u;
}

}  // namespace lumi::detail
