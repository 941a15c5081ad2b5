// SPDX-License-Identifier: MIT
#include "model/positions.h"

namespace lumi::baker
{
namespace
{

// How many times farther from the origin than they are large: below it binary32 keeps 20 bits of the shape.
constexpr double kFar = 16;

}  // namespace

CentredPositions centred(const std::vector<Point>& points)
{
    CentredPositions result;
    if (points.empty()) return result;
    Point low = points[0], high = points[0], middle{};
    for (const Point& p : points) {
        for (size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    }
    double size = 0, distance = 0;
    for (size_t k = 0; k < 3; ++k) {
        middle[k] = (low[k] + high[k]) / 2;
        size = std::max(size, high[k] - low[k]);
        distance = std::max(distance, std::abs(middle[k]));
    }
    if (distance > kFar * size) result.origin = middle;
    const Point& o = result.origin;
    result.positions.reserve(points.size());
    for (const Point& p : points) {
        result.positions.push_back(
            {static_cast<float>(p[0] - o[0]), static_cast<float>(p[1] - o[1]), static_cast<float>(p[2] - o[2])});
    }
    return result;
}

}  // namespace lumi::baker
