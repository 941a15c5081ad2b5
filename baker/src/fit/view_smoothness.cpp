// SPDX-License-Identifier: MIT
#include "fit/view_smoothness.h"

#include <cmath>
#include <set>

#include "lumi/detail/lattice.h"

namespace lumi::baker
{
namespace
{

using detail::format::kViewNodes;

constexpr int32_t kDirectionScale = 16384;
constexpr double kLowest = -0.3;  // a direction's height in a frame; the nodes end a little above

detail::ViewDirection node_direction(uint32_t node)
{
    const Vec3q30 p = detail::point(detail::Lattice(detail::format::kViewLattice), node);
    constexpr int32_t kUnit = kOneQ30 / kDirectionScale;
    return {p.x / kUnit, p.y / kUnit, p.z / kUnit};
}

using NodePair = std::pair<uint32_t, uint32_t>;

// Those that some direction lies between.
std::vector<NodePair> neighbouring_nodes()
{
    constexpr uint32_t kProbes = 20000;
    std::set<NodePair> pairs;
    for (uint32_t k = 0; k < kProbes; ++k) {
        const Vec3q30 p = detail::point(detail::Lattice(kProbes), k);
        const detail::ViewTaps taps = detail::view_taps(p.x >> 15, p.y >> 15, p.z >> 15);
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j)
                if (taps.weight_q8[i] != 0 && taps.weight_q8[j] != 0 && taps.node[i] < taps.node[j])
                    pairs.insert({taps.node[i], taps.node[j]});
        }
    }
    return {pairs.begin(), pairs.end()};
}

std::set<NodePair> edges_of(const PatchMesh& mesh)
{
    std::set<NodePair> edges;
    const auto add = [&](uint32_t a, uint32_t b) { edges.insert({std::min(a, b), std::max(a, b)}); };
    for (const PatchMesh::Patch& p : mesh.patches) {
        add(p.a, p.b);
        add(p.b, p.c);
        add(p.c, p.a);
        if (p.d != PatchMesh::kNone) {
            add(p.d, p.b);
            add(p.d, p.c);
        }
    }
    return edges;
}

detail::ViewDirection turned(const ViewTurn& turn, const detail::ViewDirection& w)
{
    return detail::in_view_frame(w, turn.x, turn.y, turn.z);
}

double height(const detail::ViewDirection& w)
{
    const double x = w.x, y = w.y, z = w.z;
    return z / std::sqrt(x * x + y * y + z * z);
}

}  // namespace

ViewSmoothness::ViewSmoothness(const FitShape& shape, const ViewExpectation& expected) : expected_(expected)
{
    for (uint32_t v = 0; v < shape.mesh.positions.size(); ++v) add_directions(v);
    for (const auto& [a, b] : edges_of(shape.mesh)) {
        add_neighbour(shape, a, b);
        add_neighbour(shape, b, a);
    }
}

void ViewSmoothness::add_directions(uint32_t vertex)
{
    static const std::vector<NodePair> kNeighbours = neighbouring_nodes();
    const float weight = std::sqrt(expected_.direction), zero = std::sqrt(expected_.zero);
    const uint32_t first = vertex * kViewNodes;
    for (const auto& [a, b] : kNeighbours)
        rows_.push_back({{first + a, first + b, first, first}, {weight, -weight, 0, 0}});
    for (uint32_t k = 0; k < kViewNodes; ++k) rows_.push_back({{first + k, first, first, first}, {zero, 0, 0, 0}});
}

// What a vertex's nodes show, another one shows in the same directions.
void ViewSmoothness::add_neighbour(const FitShape& shape, uint32_t vertex, uint32_t other)
{
    const float weight = std::sqrt(expected_.neighbour);
    for (uint32_t k = 0; k < kViewNodes; ++k) {
        const detail::ViewDirection local = turned(shape.turns[other], turned(shape.turns[vertex], node_direction(k)));
        if (height(local) < kLowest) continue;
        const detail::ViewTaps taps = detail::view_taps(local.x, local.y, local.z);
        Row row = {{vertex * kViewNodes + k}, {weight}};
        for (size_t t = 0; t < 3; ++t) {
            row.nodes[t + 1] = other * kViewNodes + taps.node[t];
            row.weights[t + 1] = -weight * static_cast<float>(taps.weight_q8[t]) / 256;
        }
        rows_.push_back(row);
    }
}

void ViewSmoothness::add_gradient(const std::vector<double>& nodes, std::vector<double>& gradient) const
{
    for (const Row& row : rows_) {
        for (size_t c = 0; c < 3; ++c) {
            double sum = 0;
            for (size_t k = 0; k < 4; ++k) sum += static_cast<double>(row.weights[k]) * nodes[3 * row.nodes[k] + c];
            for (size_t k = 0; k < 4; ++k) gradient[3 * row.nodes[k] + c] += static_cast<double>(row.weights[k]) * sum;
        }
    }
}

void ViewSmoothness::add_diagonal(std::vector<double>& diagonal) const
{
    for (const Row& row : rows_) {
        for (size_t k = 0; k < 4; ++k) {
            for (size_t c = 0; c < 3; ++c) {
                diagonal[3 * row.nodes[k] + c] +=
                    static_cast<double>(row.weights[k]) * static_cast<double>(row.weights[k]);
            }
        }
    }
}

}  // namespace lumi::baker
