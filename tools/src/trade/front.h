// SPDX-License-Identifier: MIT
// Which ways to draw are worth a look: those that no other one beats in speed and in accuracy at once.
#pragma once

#include <cstddef>
#include <vector>

namespace lumi::trade
{

struct Point {
    double frames_per_second, psnr_db;
    bool is_possible = true;  // impossible ones neither stand on the front nor beat others
};

// Accuracy that differs by less is the same.
inline constexpr double kSameDb = 0.01;

// The places of those that no other one beats, the fastest first. Of equals the first one stands for all.
std::vector<size_t> front_of(const std::vector<Point>& points);

}  // namespace lumi::trade
