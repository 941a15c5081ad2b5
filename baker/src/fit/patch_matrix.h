// SPDX-License-Identifier: MIT
// A patch's normal equations once its texels are eliminated: A = Σ w wᵀ − Σ cₜ cₜᵀ / nₜ. w: a light path's weights of
// nodes; cₜ: their sum over the nₜ paths of texel t. Only nodes that some path saw have rows, so one product costs as
// much for ten thousand texels as for one. Both sums are times the patch's weight.
#pragma once

#include "fit/fit_sums.h"

namespace lumi::baker
{

class PatchMatrix
{
public:
    PatchMatrix() = default;
    explicit PatchMatrix(const PatchSums& sums);

    // Numbers are 3 a node, of kPatchNodes nodes. part += A · nodes.
    void add_product(const std::vector<double>& nodes, std::vector<double>& part) const;
    // f(a, b, number) for each pair of nodes that are seen, in both orders.
    template <class Function>
    void each(Function f) const
    {
        for (size_t i = 0; i < nodes_.size(); ++i)
            for (size_t j = 0; j < nodes_.size(); ++j) f(nodes_[i], nodes_[j], rows_[i * nodes_.size() + j]);
    }

private:
    std::vector<uint16_t> nodes_;
    std::vector<float> rows_;  // symmetric
};

}  // namespace lumi::baker
