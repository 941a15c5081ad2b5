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

}  // namespace lumi::detail
