// SPDX-License-Identifier: MIT
// Lists of triangles in ProxyMemory: bands hold the first triangle of a list, links the next after each, the last one
// itself. A link's upper bits tell how many bands further a triangle reaches, so that most of those that a stripe need
// not draw cost a handful of instructions.
#pragma once

#include <cstdint>

namespace lumi::proxy_math
{

inline constexpr uint16_t kEmptyBand = 0xFFFF;
inline constexpr uint32_t kLinkBits = 13;  // kMaxProxyTriangles
inline constexpr uint32_t kLinkMask = (uint32_t{1} << kLinkBits) - 1;

}  // namespace lumi::proxy_math
