// SPDX-License-Identifier: MIT
// Clusters of colours.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/sampler.h"

namespace lumi::baker
{

using ColourPoint = std::array<float, 4>;

struct NearestCentre {
    size_t index;
    float distance2;
};

// The lowest of equally near ones. Cost: a distance to each.
NearestCentre nearest_centre(const std::vector<ColourPoint>& centres, const ColourPoint& p);

// k-means++'s draw: an index with probability proportional to its squared distance; none where all are zero.
std::optional<size_t> drawn_by_distance(const std::vector<float>& distances2, Sampler& sampler);

// k-means with k-means++ seeding: centres of `points` that follow after `fixed`, which stay, `count` in all or fewer
// where that many different points are not there. The same points, in the same order, give the same centres.
std::vector<ColourPoint> k_means(const std::vector<ColourPoint>& points, std::vector<ColourPoint> fixed, size_t count,
                                 uint64_t seed);

}  // namespace lumi::baker
