// SPDX-License-Identifier: MIT
// What view tables are expected to be before a path is traced: small, and alike in neighbouring directions and at
// neighbouring vertices. Directions that no path saw are filled by it.
#pragma once

#include "fit/fit_shape.h"

namespace lumi::baker
{

// How many light paths each expectation is worth: the noise of a path against how different nodes are, squared.
struct ViewExpectation {
    float direction = 3;  // neighbouring nodes of a vertex are alike
    float neighbour = 3;  // neighbouring vertices are alike in the same direction
    float zero = 0.5f;    // nodes are small
};

// A sum of squares, of Σ weight · node each; weights are in units of a path's.
class ViewSmoothness
{
public:
    explicit ViewSmoothness(const FitShape& shape, const ViewExpectation& expected = {});

    // All by channel: 3 numbers a node.
    void add_gradient(const std::vector<double>& nodes, std::vector<double>& gradient) const;
    void add_diagonal(std::vector<double>& diagonal) const;

private:
    struct Row {
        std::array<uint32_t, 4> nodes;
        std::array<float, 4> weights;
    };
    void add_directions(uint32_t vertex);
    void add_neighbour(const FitShape& shape, uint32_t vertex, uint32_t other);

    const ViewExpectation expected_;
    std::vector<Row> rows_;
};

}  // namespace lumi::baker
