// SPDX-License-Identifier: MIT
// Lists of triangles in SurfaceMemory: a band holds the first triangle of those that begin in its scanlines, a link the
// next after each, the last one itself. A link's upper bits tell how many bands further a triangle reaches.
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

// Bits of triangles that have a side on an outline, after the links.
inline uint16_t* outline_bits(const SurfaceFrame& frame)
{
    return frame.memory.links + 2 * frame.field.patch_count;
}

inline bool has_outline(const SurfaceFrame& frame, uint32_t triangle)
{
    return ((outline_bits(frame)[triangle >> 4] >> (triangle & 15)) & 1) != 0;
}

}  // namespace lumi::detail
