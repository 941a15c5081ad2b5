// SPDX-License-Identifier: MIT
#include "guided/chart_mask.h"

namespace lumi::baker
{
namespace
{

constexpr float kEdgeStep = 0.25f;  // grid points, between the places at which an edge marks its cell
constexpr float kMaxEdgeSteps = 4096;

void add_cell(ChartMask& mask, const Vec2& place)
{
    const int64_t u = static_cast<int64_t>(std::floor(place.x)), v = static_cast<int64_t>(std::floor(place.y));
    mask.add(u, v);
    mask.add(u + 1, v);
    mask.add(u, v + 1);
    mask.add(u + 1, v + 1);
}

// An edge is an arc in the chart; its cells are marked closely enough that none between is passed over by more than a
// corner, which the margin covers.
void add_edge(ChartMask& mask, const ChartGeometry& chart, const Vec3& a, const Vec3& b)
{
    constexpr int kPieces = 4;
    for (int piece = 0; piece < kPieces; ++piece) {
        const auto at = [&](float t) { return a + (b - a) * ((static_cast<float>(piece) + t) / kPieces); };
        const Vec2 start = chart.place(at(0)), end = chart.place(at(1));
        const float span = std::max(std::abs(end.x - start.x), std::abs(end.y - start.y));
        const int steps = 1 + static_cast<int>(std::min(span / kEdgeStep, kMaxEdgeSteps));
        for (int k = 0; k <= steps; ++k) {
            add_cell(mask, chart.place(at(static_cast<float>(k) / static_cast<float>(steps))));
        }
    }
}

}  // namespace

void ChartMask::add(int64_t u, int64_t v)
{
    if (u >= 0 && u < side_ && v >= 0 && v < side_) {
        set_[static_cast<size_t>(v) * side_ + static_cast<size_t>(u)] = 1;
    }
}

ChartMask ChartMask::grown() const
{
    ChartMask result(side_);
    for (int64_t v = 0; v < side_; ++v) {
        for (int64_t u = 0; u < side_; ++u) {
            if (has(static_cast<uint32_t>(u), static_cast<uint32_t>(v))) {
                for (int64_t k = 0; k < 9; ++k) {
                    result.add(u - 1 + k % 3, v - 1 + k / 3);
                }
            }
        }
    }
    return result;
}

ChartMask ChartMask::blocks(uint32_t shift) const
{
    ChartMask result((side_ >> shift) + 1);
    for (uint32_t v = 0; v < side_; ++v) {
        for (uint32_t u = 0; u < side_; ++u) {
            if (has(u, v)) {
                result.add(u >> shift, v >> shift);
            }
        }
    }
    return result;
}

ChartRows ChartMask::rows() const
{
    ChartRows result;
    for (uint32_t v = 0; v < side_; ++v) {
        const auto begin = set_.begin() + static_cast<std::ptrdiff_t>(size_t{v} * side_), end = begin + side_;
        const auto first = std::find(begin, end, 1);
        if (first == end && result.rows.empty()) {
            result.first_v = v + 1;
            continue;
        }
        auto last = end;
        while (last != first && last[-1] == 0) {
            --last;
        }
        const uint32_t count = static_cast<uint32_t>(last - first);
        result.rows.push_back({count == 0 ? 0 : static_cast<uint32_t>(first - begin), count, result.texel_count});
        result.texel_count += count;
    }
    while (!result.rows.empty() && result.rows.back().count == 0) {
        result.rows.pop_back();
    }
    result.first_v = result.rows.empty() ? 0 : result.first_v;
    return result;
}

ChartMask proxy_mask(const ChartGeometry& chart, const ProxyTracer& proxy)
{
    ChartMask mask(chart.side());
    for (uint32_t v = 0; v < chart.side(); ++v) {
        for (uint32_t u = 0; u < chart.side(); ++u) {
            const std::optional<Ray> ray = chart.ray({static_cast<float>(u), static_cast<float>(v)});
            if (ray && proxy.touches(*ray)) {
                mask.add(u, v);
            }
        }
    }
    const Mesh& mesh = proxy.mesh();
    for (const Mesh::Corners& c : mesh.corners) {
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t a = c[k], b = c[(k + 1) % 3];
            add_edge(mask, chart, mesh.positions[a], mesh.positions[b]);
        }
    }
    return mask.grown();
}

ChartMask disc_mask(const ChartGeometry& chart)
{
    ChartMask mask(chart.side());
    for (uint32_t v = 0; v < chart.side(); ++v) {
        for (uint32_t u = 0; u < chart.side(); ++u) {
            if (chart.ray({static_cast<float>(u), static_cast<float>(v)})) {
                mask.add(u, v);
            }
        }
    }
    return mask.grown();
}

}  // namespace lumi::baker
