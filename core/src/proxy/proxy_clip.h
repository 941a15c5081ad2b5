// SPDX-License-Identifier: MIT
#pragma once

#include "proxy/proxy_fill.h"

namespace lumi::proxy_math
{

// Fills a triangle of which some corner is not on the sample grid: cut at the near plane and at the guard band, exactly
// as every neighbour that shares the edge. 64-bit products and divisions; rare.
void fill_clipped(const ProxyFrame& frame, const Triple12& triangle, const DepthTarget& target);

}  // namespace lumi::proxy_math
