// SPDX-License-Identifier: MIT
// Draws an index with a probability proportional to its weight.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lumi::baker
{

class Distribution
{
public:
    Distribution() = default;
    // Weights are finite and >= 0. Without a positive one nothing may be drawn.
    explicit Distribution(const std::vector<double>& weights);

    struct Draw {
        size_t index;
        float rest;  // u's place within the index's share, uniform in [0, 1) again
    };

    bool empty() const { return !(total() > 0); }
    double total() const { return cumulative_.empty() ? 0 : cumulative_.back(); }
    // u in [0, 1). Never an index of weight 0. Cost: constant in the mean over u; the guide table of Chen and Asau, "On
    // Generating Random Variates from an Empirical Distribution", AIIE Transactions 6(2), 1974.
    Draw draw(float u) const;
    float probability(size_t index) const;

private:
    std::vector<double> cumulative_;
    std::vector<uint32_t> guide_;  // for each equal share of u, the index that its first number draws
};

}  // namespace lumi::baker
