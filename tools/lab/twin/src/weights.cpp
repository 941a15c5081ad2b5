// SPDX-License-Identifier: MIT
#include "lumi/twin/weights.h"

#include <algorithm>
#include <cmath>

namespace lumi::twin
{
Weights sorted_by_distance(const std::vector<Vec3>& all, const Vec3& q, uint32_t count)
{
    Weights near;
    for (uint32_t i = 0; i < all.size(); ++i) near.emplace_back(i, dot(all[i] - q, all[i] - q));
    const auto by_distance = [](const auto& a, const auto& b) { return a.second < b.second; };
    const size_t kept = std::min<size_t>(count, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<long>(kept), near.end(), by_distance);
    near.resize(kept);
    return near;
}

Weights nearest_weights(const std::vector<Vec3>& all, const Vec3& q)
{
    return {{sorted_by_distance(all, q, 1)[0].first, 1.0}};
}

CellPoint nearest_point(const std::vector<Vec3>& all, const Vec3& q, double border_share)
{
    const Weights two = sorted_by_distance(all, q, 2);
    const double apart = length(all[two[0].first] - all[two[1].first]);
    const double from_border = (two[1].second - two[0].second) / (2 * apart);
    return {two[0].first, from_border < border_share * spacing(static_cast<uint32_t>(all.size()))};
}

Weights paper_weights(const std::vector<Vec3>& all, const Vec3& q, uint32_t count)
{
    Weights near = sorted_by_distance(all, q, count);
    const double radius2 = 4 * kPi / static_cast<double>(all.size());
    double sum = 0;
    for (auto& [i, w] : near) {
        w = std::pow(std::fmax(0.0, 1 - w / radius2), 2);
        sum += w;
    }
    for (auto& [i, w] : near) w /= sum;
    return near;
}

}  // namespace lumi::twin
