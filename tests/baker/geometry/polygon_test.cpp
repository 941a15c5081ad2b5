// SPDX-License-Identifier: MIT
#include "geometry/polygon.h"

#include <catch2/catch.hpp>

namespace lumi::baker
{
namespace
{

// Sum of the triangles' areas, and the sum of their area vectors, which for a sound cut have the same length.
void check_area(const std::vector<Vec3>& polygon, double area)
{
    double total = 0;
    Vec3 sum;
    const auto triangles = triangulate(polygon);
    REQUIRE(triangles.size() == polygon.size() - 2);
    for (const auto& t : triangles) {
        const Vec3 a = cross(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]]) * 0.5f;
        total += static_cast<double>(length(a));
        sum = sum + a;
    }
    CHECK(total == Approx(area));
    CHECK(static_cast<double>(length(sum)) == Approx(area));
}

}  // namespace

TEST_CASE("polygon: convex, concave and star-shaped ones are cut without overlap")
{
    check_area({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 0.5);
    check_area({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, 2);
    check_area({{0, 0, 0}, {2, 0, 0}, {0.5f, 0.5f, 0}, {0, 2, 0}}, 1);                  // dart
    check_area({{0, 0, 5}, {3, 0, 5}, {3, 1, 5}, {1, 1, 5}, {1, 3, 5}, {0, 3, 5}}, 5);  // L
    check_area({{0, 1, 0}, {0, 0, 0}, {0, 0, 4}, {0, 1, 4}, {0, 1, 3}, {0, 0.5f, 3}, {0, 0.5f, 1}, {0, 1, 1}}, 3);  // C
    std::vector<Vec3> star;
    for (int k = 0; k < 20; ++k) {
        const float radius = k % 2 ? 0.4f : 1;
        star.push_back({radius * std::cos(kPi * static_cast<float>(k) / 10), 0,
                        radius * std::sin(kPi * static_cast<float>(k) / 10)});
    }
    check_area(star, 10 * 0.4 * std::sin(static_cast<double>(kPi) / 10));
}

TEST_CASE("polygon: a disc of a million corners, and a large star, are cut at once")
{
    for (const bool star : {false, true}) {
        std::vector<Vec3> around;
        constexpr int kCorners = 1'000'000;
        for (int k = 0; k < kCorners; ++k) {
            const double angle = 2 * static_cast<double>(kPi) * k / kCorners, radius = star && k % 2 ? 0.5 : 1;
            around.push_back(
                {static_cast<float>(radius * std::cos(angle)), static_cast<float>(radius * std::sin(angle)), 0});
        }
        CHECK(triangulate(around).size() == kCorners - 2);
    }
}

TEST_CASE("polygon: a corner on an edge and a repeated corner still leave the whole area")
{
    check_area({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, 2);
    double total = 0;
    const std::vector<Vec3> repeated = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (const auto& t : triangulate(repeated)) {
        total +=
            static_cast<double>(length(cross(repeated[t[1]] - repeated[t[0]], repeated[t[2]] - repeated[t[0]]))) / 2;
    }
    CHECK(total == Approx(1));
}

TEST_CASE("polygon: nonsense ends all the same")
{
    CHECK(triangulate({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size() == 2);  // crosses itself
    CHECK(triangulate({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).size() == 2);
    CHECK(triangulate({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).size() == 2);
}

}  // namespace lumi::baker
