// SPDX-License-Identifier: MIT
// Which rows no other one beats.
#include "trade/trade.h"

#include <catch2/catch.hpp>

namespace lumi::trade
{

TEST_CASE("the front holds what nothing beats in speed and accuracy at once, the fastest first")
{
    const std::vector<Point> points = {{10, 30}, {20, 28}, {15, 27}, {10, 29}, {5, 30}, {1, 33}};
    CHECK(front_of(points) == std::vector<size_t>{1, 0, 5});
}

TEST_CASE("of equals the first one stands for all, and accuracy within noise is the same")
{
    CHECK(front_of({{10, 30}, {10, 30}}) == std::vector<size_t>{0});
    CHECK(front_of({{10, 30}, {9, 30.005}}) == std::vector<size_t>{0});
    CHECK(front_of({{10, 30}, {9, 30.02}}) == std::vector<size_t>{0, 1});
}

TEST_CASE("what is impossible beats nothing")
{
    CHECK(front_of({{50, 40, false}, {10, 30}}) == std::vector<size_t>{1});
    CHECK(front_of({{50, 40, false}}).empty());
    CHECK(front_of({}).empty());
}

}  // namespace lumi::trade
