// SPDX-License-Identifier: MIT
// Draws an index with a probability proportional to its weight.
#pragma once

#include <cstddef>
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
    // u in [0, 1). Never an index of weight 0. Cost: logarithmic.
    Draw draw(float u) const;
    float probability(size_t index) const;

private:
    std::vector<double> cumulative_;
};

}  // namespace lumi::baker
