// SPDX-License-Identifier: MIT
#include "image/k_means.h"

#include <catch2/catch.hpp>

namespace lumi::baker
{

TEST_CASE("k-means finds clusters that lie apart, and keeps fixed centres")
{
    std::vector<ColourPoint> points;
    for (int k = 0; k < 300; ++k)
        points.push_back({static_cast<float>(100 * (k % 3)), static_cast<float>(k / 3 % 5), 0, 0});
    const std::vector<ColourPoint> centres = k_means(points, {{-50, 0, 0, 0}}, 4, 1);
    REQUIRE(centres.size() == 4);
    CHECK(centres[0] == ColourPoint{-50, 0, 0, 0});
    for (const ColourPoint& p : points) CHECK(nearest_centre(centres, p).distance2 < 4.1f);
    CHECK(k_means(points, {}, 200, 1).size() == 15);  // no more than there are different points
    CHECK(k_means({}, {}, 16, 1).empty());
}

}  // namespace lumi::baker
