// SPDX-License-Identifier: MIT
// Which grid points of an origin's chart a field needs.
#pragma once

#include "guided/chart_geometry.h"
#include "guided/guided_parts.h"
#include "proxy/proxy_tracer.h"

namespace lumi::baker
{

class ChartMask
{
public:
    explicit ChartMask(uint32_t side) : side_(side), set_(size_t{side} * side, 0) {}

    uint32_t side() const { return side_; }
    bool has(uint32_t u, uint32_t v) const { return set_[size_t{v} * side_ + u] != 0; }
    // Places beside the grid are passed over.
    void add(int64_t u, int64_t v);
    // With all neighbours.
    ChartMask grown() const;
    // Of blocks of 2^shift × 2^shift grid points: those with a member.
    ChartMask blocks(uint32_t shift) const;
    // Each row from its first member to its last.
    ChartRows rows() const;

private:
    uint32_t side_;
    std::vector<uint8_t> set_;
};

// Every tap of every point of the proxy, also of those that the origin does not see, and a margin of one grid point.
ChartMask proxy_mask(const ChartGeometry& chart, const ProxyTracer& proxy);

// The whole disc.
ChartMask disc_mask(const ChartGeometry& chart);

}  // namespace lumi::baker
