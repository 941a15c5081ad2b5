// SPDX-License-Identifier: MIT
#include "trade/front.h"

#include <algorithm>

namespace lumi::trade
{

std::vector<size_t> front_of(const std::vector<Point>& points)
{
    std::vector<size_t> order;
    for (size_t k = 0; k < points.size(); ++k)
        if (points[k].is_possible) order.push_back(k);
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
        const Point &x = points[a], &y = points[b];
        return x.frames_per_second != y.frames_per_second ? x.frames_per_second > y.frames_per_second
                                                          : x.psnr_db > y.psnr_db;
    });
    std::vector<size_t> front;
    for (const size_t k : order)
        if (front.empty() || points[k].psnr_db >= points[front.back()].psnr_db + kSameDb) front.push_back(k);
    return front;
}

}  // namespace lumi::trade
