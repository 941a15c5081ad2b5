// SPDX-License-Identifier: MIT
// Lists of triangles in SurfaceMemory: a band holds the first triangle of those that begin in its rows, a link the next
// after each, the last one itself. A link's upper bits tell how many bands further a triangle reaches.
#pragma once

#include <cstdint>

namespace lumi::surfaces
{

inline constexpr uint16_t kEmptyBand = 0xFFFF;
inline constexpr uint16_t kUnlisted = 0xFFFF;  // the link of a triangle that is in no list
inline constexpr uint32_t kLinkBits = 13;
inline constexpr uint32_t kLinkMask = (uint32_t{1} << kLinkBits) - 1;
inline constexpr int32_t kBandReach = 7;  // a triangle's bands, at most; 8 would make a link look like kUnlisted

}  // namespace lumi::surfaces
