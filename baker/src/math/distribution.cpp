// SPDX-License-Identifier: MIT
#include "math/distribution.h"

#include <algorithm>

namespace lumi::baker
{

Distribution::Distribution(const std::vector<double>& weights)
{
    cumulative_.reserve(weights.size());
    double sum = 0;
    for (const double weight : weights) {
        sum += weight;
        cumulative_.push_back(sum);
    }
}

Distribution::Draw Distribution::draw(float u) const
{
    constexpr float kBelowOne = 0x1.fffffep-1f;
    const double target = static_cast<double>(u) * total();
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, target);
    const size_t index = static_cast<size_t>(found - cumulative_.begin());
    const double before = index == 0 ? 0 : cumulative_[index - 1];
    const double rest = (target - before) / (cumulative_[index] - before);
    return {index, std::clamp(static_cast<float>(rest), 0.0f, kBelowOne)};
}

float Distribution::probability(size_t index) const
{
    const double before = index == 0 ? 0 : cumulative_[index - 1];
    return static_cast<float>((cumulative_[index] - before) / total());
}

}  // namespace lumi::baker
