// SPDX-License-Identifier: MIT
#include "fit/view_smoothness.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "lumi/detail/lattice.h"

namespace lumi::baker
{

namespace
{

// The number of node `local` of patch p's sums among all vertices' nodes.
uint32_t node_of(const FitShape& shape, uint32_t p, uint32_t local)
{
    return shape.vertex(p, local / detail::format::kViewNodes) * detail::format::kViewNodes +
           local % detail::format::kViewNodes;
}

}  // namespace

std::vector<double> node_weights(const FitSums& sums)
{
    const FitShape& shape = sums.shape();
    std::vector<double> weights(detail::format::kViewNodes * shape.mesh.positions.size());
    for (uint32_t p = 0; p < shape.mesh.patches.size(); ++p) {
        const double unit = kWeightUnit * kWeightUnit * sums.patches()[p].weight;
        sums.patches()[p].pairs.each([&](uint32_t a, uint32_t b, int64_t sum) {
            if (a == b) weights[node_of(shape, p, a)] += unit * static_cast<double>(sum);
        });
    }
    return weights;
}

std::vector<uint8_t> viewed_vertices(const FitSums& sums, const FitModel& model, double levels)
{
    using detail::format::kViewNodes;
    const std::vector<double> weights = node_weights(sums);
    const std::vector<uint8_t>& has_gloss = sums.shape().has_gloss;
    std::vector<uint8_t> viewed;
    for (size_t v = 0; v < sums.shape().mesh.positions.size(); ++v) {
        double sum = 0, all = 0;
        for (size_t k = v * kViewNodes; k < (v + 1) * kViewNodes; ++k) {
            double square = 0;
            for (const float channel : model.nodes[k]) square += static_cast<double>(channel * channel);
            sum += weights[k] * square / 3;
            all += weights[k];
        }
        const bool is_needed = !has_gloss.empty() && has_gloss[v] != 0;
        viewed.push_back(is_needed || sum > levels * levels * all ? 1 : 0);
    }
    return viewed;
}

NodeProducts::NodeProducts(const FitSums& sums)
{
    const FitShape& shape = sums.shape();
    rows_.resize(detail::format::kViewNodes * shape.mesh.positions.size());
    for (uint32_t p = 0; p < shape.mesh.patches.size(); ++p) {
        const double unit = kWeightUnit * kWeightUnit * sums.patches()[p].weight;
        sums.patches()[p].pairs.each([&](uint32_t a, uint32_t b, int64_t sum) {
            const uint32_t i = node_of(shape, p, a), j = node_of(shape, p, b);
            const auto product = static_cast<float>(unit * static_cast<double>(sum));
            if (i != j) {
                rows_[i].push_back({j, product});
                rows_[j].push_back({i, product});
            }
        });
    }
}

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

// The variance of a light path around each vertex, a channel, times the weight that paths have there.
std::vector<double> noise_at(const FitSums& sums)
{
    constexpr double kLeast = 1e-3;  // levels²
    const FitShape& shape = sums.shape();
    std::vector<double> scatter(shape.mesh.positions.size()), count(shape.mesh.positions.size());
    for (uint32_t p = 0; p < shape.mesh.patches.size(); ++p) {
        const TexelSums all = scatter_of(sums.patches()[p]);
        for (uint32_t corner = 0; corner < 4; ++corner) {
            const uint32_t v = shape.vertex(p, corner);
            if (v == PatchMesh::kNone) continue;
            const double weight = sums.patches()[p].weight;
            scatter[v] += weight * weight * all.variance() * all.count;
            count[v] += weight * all.count;
        }
    }
    for (size_t v = 0; v < scatter.size(); ++v) scatter[v] = std::max(scatter[v] / std::max(count[v], 1.0), kLeast);
    return scatter;
}

double height(const detail::ViewDirection& w)
{
    const double x = w.x, y = w.y, z = w.z;
    return z / std::sqrt(x * x + y * y + z * z);
}

}  // namespace

ViewSmoothness::ViewSmoothness(const FitShape& shape, const std::vector<uint8_t>& viewed)
{
    expected_.assign(shape.mesh.positions.size(), kUnknown);
    for (uint32_t v = 0; v < shape.mesh.positions.size(); ++v)
        if (viewed[v] != 0) add_directions(v);
    for (const auto& [a, b] : edges_of(shape.mesh)) {
        if (viewed[a] == 0 && viewed[b] == 0) continue;
        add_neighbour(shape, a, b);
        add_neighbour(shape, b, a);
    }
}

void ViewSmoothness::add_directions(uint32_t vertex)
{
    static const std::vector<NodePair> kNeighbours = neighbouring_nodes();
    const uint32_t first = vertex * kViewNodes;
    for (const auto& [a, b] : kNeighbours)
        rows_.push_back({{first + a, first + b, first, first}, {1, -1, 0, 0}, direction});
    for (uint32_t k = 0; k < kViewNodes; ++k) rows_.push_back({{first + k, first, first, first}, {1, 0, 0, 0}, zero});
}

// Two vertices show alike in the same directions.
void ViewSmoothness::add_neighbour(const FitShape& shape, uint32_t vertex, uint32_t other)
{
    for (uint32_t k = 0; k < kViewNodes; ++k) {
        const detail::ViewDirection local = turned(shape.turns[other], turned(shape.turns[vertex], node_direction(k)));
        if (height(local) < kLowest) continue;
        const detail::ViewTaps taps = detail::view_taps(local.x, local.y, local.z);
        Row row = {{vertex * kViewNodes + k}, {1}, neighbour};
        for (size_t t = 0; t < 3; ++t) {
            row.nodes[t + 1] = other * kViewNodes + taps.node[t];
            row.weights[t + 1] = -static_cast<float>(taps.weight_q8[t]) / 256;
        }
        rows_.push_back(row);
    }
}

ViewSmoothness::Evidence ViewSmoothness::evidence_of(const Row& row, const std::vector<double>& seen,
                                                     const std::vector<double>& variances, const FitModel& model) const
{
    const double trust = row.kind == direction ? std::min(seen[row.nodes[0]], seen[row.nodes[1]]) : seen[row.nodes[0]];
    double square = 0;
    for (size_t c = 0; c < 3; ++c) {
        double sum = 0;
        for (size_t k = 0; k < 4; ++k)
            sum += static_cast<double>(row.weights[k]) * static_cast<double>(model.nodes[row.nodes[k]][c]);
        square += sum * sum / 3;
    }
    for (size_t k = 0; k < 4; ++k)
        square += static_cast<double>(row.weights[k] * row.weights[k]) * variances[row.nodes[k]];
    return {trust * square, trust};
}

void ViewSmoothness::learn(const FitSums& sums, const FitModel& model)
{
    constexpr double kLeastWorth = 0.01, kMostWorth = 100;
    constexpr double kShare = 0.15;  // a node has some 16 rows, so each is worth less than if it stood alone
    const std::vector<double> noise = noise_at(sums), seen = node_weights(sums);
    std::fill(expected_.begin(), expected_.end(), kUnknown);
    std::vector<double> variances = worth_of_nodes();
    for (size_t k = 0; k < seen.size(); ++k) variances[k] = noise[k / kViewNodes] / (variances[k] + seen[k]);
    std::vector<std::array<Evidence, kKinds>> found(expected_.size());
    for (const Row& row : rows_) {
        const Evidence e = evidence_of(row, seen, variances, model);
        Evidence& all = found[row.nodes[0] / kViewNodes][row.kind];
        all = {all.squares + e.squares, all.weight + e.weight};
    }
    for (size_t v = 0; v < found.size(); ++v) {
        for (size_t kind = 0; kind < kKinds; ++kind) {
            const auto& [squares, weight] = found[v][kind];
            if (squares > 0)
                expected_[v][kind] =
                    static_cast<float>(std::clamp(kShare * noise[v] * weight / squares, kLeastWorth, kMostWorth));
        }
    }
}

void ViewSmoothness::add_gradient(const std::vector<double>& nodes, std::vector<double>& gradient) const
{
    for (const Row& row : rows_) {
        const auto times = static_cast<double>(worth(row));
        for (size_t c = 0; c < 3; ++c) {
            double sum = 0;
            for (size_t k = 0; k < 4; ++k) sum += static_cast<double>(row.weights[k]) * nodes[3 * row.nodes[k] + c];
            for (size_t k = 0; k < 4; ++k)
                gradient[3 * row.nodes[k] + c] += times * static_cast<double>(row.weights[k]) * sum;
        }
    }
}

std::vector<double> ViewSmoothness::worth_of_nodes() const
{
    std::vector<double> worths(expected_.size() * kViewNodes);
    for (const Row& row : rows_)
        for (size_t k = 0; k < 4; ++k)
            worths[row.nodes[k]] += static_cast<double>(worth(row) * row.weights[k] * row.weights[k]);
    return worths;
}

}  // namespace lumi::baker
