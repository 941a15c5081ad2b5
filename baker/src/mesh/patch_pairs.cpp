// SPDX-License-Identifier: MIT
#include "mesh/patch_pairs.h"

#include <set>
#include <unordered_map>

namespace lumi::baker
{
namespace
{

constexpr float kSkewCost = 0.5f;  // cost of a cosine of 1 at a corner; a shape off by its diagonal costs 1
constexpr int kMaxChain = 16;      // pairs that are changed at once to find a partner for a lone triangle
constexpr uint32_t kAlone = UINT32_MAX;

// Triangles (a, b, c) and (d, c, b) beside each other; `first` has corner a.
struct Pair {
    uint32_t first, second;
    PatchMesh::Patch patch;
    float cost;
};

float cosine_at(const Vec3& apex, const Vec3& a, const Vec3& b)
{
    return dot(normalized(a - apex), normalized(b - apex));
}

float cost_of(const Mesh& mesh, const PatchMesh::Patch& p)
{
    const Vec3 &a = mesh.positions[p.a], &b = mesh.positions[p.b], &c = mesh.positions[p.c], &d = mesh.positions[p.d];
    const float skew = std::abs(cosine_at(a, b, c)) + std::abs(cosine_at(d, b, c));
    return length(a + d - b - c) / length(b - c) + kSkewCost * skew;
}

std::vector<Pair> pairs_of(const Mesh& mesh)
{
    // By the edge from its first to its second vertex: triangle and the vertex opposite.
    std::unordered_map<uint64_t, std::vector<std::pair<uint32_t, uint32_t>>> sides;
    const auto key = [](uint32_t from, uint32_t to) { return uint64_t{from} << 32 | to; };
    std::vector<Pair> pairs;
    for (uint32_t k = 0; k < mesh.triangle_count(); ++k) {
        for (size_t i = 0; i < 3; ++i) {
            const uint32_t a = mesh.corners[k][i], b = mesh.corners[k][(i + 1) % 3], c = mesh.corners[k][(i + 2) % 3];
            for (const auto& [other, d] : sides[key(c, b)]) {
                if (d != a) {
                    pairs.push_back({k, other, {a, b, c, d}, 0});
                    pairs.back().cost = cost_of(mesh, pairs.back().patch);
                }
            }
            sides[key(b, c)].emplace_back(k, a);
        }
    }
    return pairs;
}

class Matching
{
public:
    explicit Matching(const Mesh& mesh)
        : pairs_(pairs_of(mesh)), around_(mesh.triangle_count()), pair_(mesh.triangle_count(), kAlone)
    {
        for (uint32_t p = 0; p < pairs_.size(); ++p) {
            around_[pairs_[p].first].push_back(p);
            around_[pairs_[p].second].push_back(p);
        }
    }

    void match_greedily()
    {
        for (uint32_t p = 0; p < pairs_.size(); ++p) waiting_.insert(rank(p));
        while (!waiting_.empty()) take(std::get<2>(*waiting_.begin()));
    }

    // Changes chains of pairs that begin and end with a lone triangle.
    void match_the_lone()
    {
        for (uint32_t k = 0; k < pair_.size(); ++k) {
            if (pair_[k] == kAlone) {
                std::vector<bool> visited(pair_.size(), false);
                rematch(k, visited, kMaxChain);
            }
        }
    }

    const Pair* pair_of(uint32_t triangle) const
    {
        return pair_[triangle] == kAlone ? nullptr : &pairs_[pair_[triangle]];
    }

private:
    // Pairs come first whose triangle has no other choice, then the best shapes.
    using Rank = std::tuple<bool, float, uint32_t>;

    uint32_t other(uint32_t p, uint32_t triangle) const
    {
        return pairs_[p].first == triangle ? pairs_[p].second : pairs_[p].first;
    }
    bool is_free(uint32_t p) const { return pair_[pairs_[p].first] == kAlone && pair_[pairs_[p].second] == kAlone; }
    bool has_choice(uint32_t triangle) const
    {
        const std::vector<uint32_t>& around = around_[triangle];
        return std::count_if(around.begin(), around.end(), [&](uint32_t p) { return is_free(p); }) > 1;
    }
    Rank rank(uint32_t p) const
    {
        return {has_choice(pairs_[p].first) && has_choice(pairs_[p].second), pairs_[p].cost, p};
    }

    void take(uint32_t p)
    {
        std::vector<uint32_t> neighbours;
        for (const uint32_t triangle : {pairs_[p].first, pairs_[p].second}) {
            for (const uint32_t q : around_[triangle]) {
                waiting_.erase({true, pairs_[q].cost, q});
                waiting_.erase({false, pairs_[q].cost, q});
                neighbours.push_back(other(q, triangle));
            }
        }
        set(p);
        for (const uint32_t triangle : neighbours) rerank(triangle);
    }

    void rerank(uint32_t triangle)
    {
        for (const uint32_t q : around_[triangle])
            if (waiting_.erase({true, pairs_[q].cost, q}) != 0) waiting_.insert(rank(q));
    }

    void set(uint32_t p) { pair_[pairs_[p].first] = pair_[pairs_[p].second] = p; }

    // Finds a partner for `triangle`, at the cost of others that find one in turn.
    bool rematch(uint32_t triangle, std::vector<bool>& visited, int chain)
    {
        visited[triangle] = true;
        for (const uint32_t p : around_[triangle]) {
            const uint32_t partner = other(p, triangle);
            if (visited[partner]) continue;
            visited[partner] = true;
            const bool was_alone = pair_[partner] == kAlone;
            if (was_alone || (chain > 0 && leaves(partner, visited, chain - 1))) {
                set(p);
                return true;
            }
        }
        return false;
    }

    bool leaves(uint32_t partner, std::vector<bool>& visited, int chain)
    {
        const uint32_t left = other(pair_[partner], partner);
        return !visited[left] && rematch(left, visited, chain);
    }

    std::vector<Pair> pairs_;
    std::vector<std::vector<uint32_t>> around_;  // pairs that a triangle could be in
    std::vector<uint32_t> pair_;                 // the pair that a triangle is in
    std::set<Rank> waiting_;
};

PatchMesh::Patch alone(const Mesh& mesh, uint32_t triangle)
{
    const Mesh::Corners& c = mesh.corners[triangle];
    const auto opposite = [&](size_t i) {
        return length(mesh.position(triangle, (i + 1) % 3) - mesh.position(triangle, (i + 2) % 3));
    };
    size_t a = opposite(1) > opposite(0) ? 1 : 0;
    a = opposite(2) > opposite(a) ? 2 : a;
    return {c[a], c[(a + 1) % 3], c[(a + 2) % 3], PatchMesh::kNone};
}

}  // namespace

std::vector<PatchMesh::Patch> paired(const Mesh& mesh)
{
    Matching matching(mesh);
    matching.match_greedily();
    matching.match_the_lone();
    std::vector<PatchMesh::Patch> patches;
    for (uint32_t k = 0; k < mesh.triangle_count(); ++k) {
        const Pair* pair = matching.pair_of(k);
        if (!pair)
            patches.push_back(alone(mesh, k));
        else if (pair->first == k)
            patches.push_back(pair->patch);
    }
    return patches;
}

}  // namespace lumi::baker
