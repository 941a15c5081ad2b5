// SPDX-License-Identifier: MIT
// What the sums of a surface bake say of view nodes: how much of all paths each carries, and which were seen together.
#pragma once

#include "fit/fit_sums.h"

namespace lumi::baker
{

// By kViewNodes * vertex + node.
std::vector<double> node_weights(const FitSums& sums);

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

}  // namespace lumi::baker
