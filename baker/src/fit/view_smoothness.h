// SPDX-License-Identifier: MIT
// The expectation of view tables: they are small, and alike in neighbouring directions and at neighbouring vertices.
// How much so is learnt from the light itself, vertex by vertex: a matt surface's tables are nearly flat, those of
// metal are not. Directions that no path saw are filled by it.
#pragma once

#include "fit/fit_sums.h"

namespace lumi::baker
{

// Reads from the sums of a surface bake how much of all paths each view node carries, and which were seen together.

// By kViewNodes * vertex + node.
std::vector<double> node_weights(const FitSums& sums);
// Vertices whose view table changes what is shown by more than so many levels, root mean square.
std::vector<uint8_t> viewed_vertices(const FitSums& sums, const FitModel& model, double levels);

// The sums of products of nodes' weights, node by node: what an error at one node adds to the gradient at others.
class NodeProducts
{
public:
    explicit NodeProducts(const FitSums& sums);

    struct Entry {
        uint32_t node;
        float product;
    };
    const std::vector<Entry>& row(size_t node) const { return rows_[node]; }

private:
    std::vector<std::vector<Entry>> rows_;
};

// A sum of squares, of Σ weight · node each, times the light paths that it is worth: the noise of a path against how
// different nodes are, squared.
class ViewSmoothness
{
public:
    // The expectation of a vertex of which nothing is known; of those that are not `viewed` nothing is ever asked.
    ViewSmoothness(const FitShape& shape, const std::vector<uint8_t>& viewed);

    // Makes each vertex's expectation what `model` shows, which was fitted to such sums: how different nodes are, and
    // how much more of that the noise of paths hides (a step of expectation maximization).
    void learn(const FitSums& sums, const FitModel& model);

    // All by channel: 3 numbers a node.
    void add_gradient(const std::vector<double>& nodes, std::vector<double>& gradient) const;
    // f(a, b, number) for each pair of nodes whose product it weighs, in both orders.
    template <class Function>
    void each(Function f) const
    {
        for (const Row& row : rows_)
            for (size_t i = 0; i < 4; ++i)
                for (size_t j = 0; j < 4; ++j)
                    f(row.nodes[i], row.nodes[j], worth(row) * row.weights[i] * row.weights[j]);
    }

private:
    enum Kind : uint8_t { direction, neighbour, zero, kKinds };
    // Σ weights · nodes; how many paths it is worth is the vertex's expectation of this kind.
    struct Row {
        std::array<uint32_t, 4> nodes;
        std::array<float, 4> weights;
        Kind kind;
    };
    using Expectation = std::array<float, kKinds>;
    static constexpr Expectation kUnknown = {1, 1, 0.2f};

    struct Evidence {
        double squares = 0, weight = 0;  // a weighted sum of squares
    };

    Evidence evidence_of(const Row& row, const std::vector<double>& seen, const std::vector<double>& variances,
                         const FitModel& model) const;
    std::vector<double> worth_of_nodes() const;
    float worth(const Row& row) const { return expected_[row.nodes[0] / detail::format::kViewNodes][row.kind]; }
    void add_directions(uint32_t vertex);
    void add_neighbour(const FitShape& shape, uint32_t vertex, uint32_t other);

    std::vector<Expectation> expected_;  // by vertex
    std::vector<Row> rows_;
};

}  // namespace lumi::baker
