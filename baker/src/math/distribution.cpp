// SPDX-License-Identifier: MIT
#include "math/distribution.h"

#include <algorithm>
#include <cstdint>

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
    guide_.reserve(weights.size());
    uint32_t index = 0;
    for (size_t k = 0; k < weights.size() && sum > 0; ++k) {
        const double target = sum * static_cast<double>(k) / static_cast<double>(weights.size());
        while (index + 1 < weights.size() && cumulative_[index] <= target) ++index;
        guide_.push_back(index);
    }
}

Distribution::Draw Distribution::draw(float u) const
{
    constexpr float kBelowOne = 0x1.fffffep-1f;
    const double target = static_cast<double>(u) * total();
    size_t index = guide_[static_cast<size_t>(static_cast<double>(u) * static_cast<double>(guide_.size()))];
    while (index > 0 && cumulative_[index - 1] > target) --index;  // the guide's rounding
    while (index + 1 < cumulative_.size() && cumulative_[index] <= target) ++index;
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
