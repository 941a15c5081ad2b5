// SPDX-License-Identifier: MIT
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <vector>

#include "lattice/polar.h"
#include "report.h"
#include "twin.h"

using namespace lumi;
using namespace lumi::detail;

namespace
{

struct Plane {
    double x, y;
};

// Lambert's projection of point i of any Spherical Fibonacci set, scaled so that a point covers an area of π.
Plane pattern_point(uint32_t i)
{
    const double turns = i / twin::kGolden;
    const double angle = 2 * twin::kPi * (turns - std::floor(turns));
    const double radius = std::sqrt(i + 0.5);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

double cross(const Plane& a, const Plane& b, const Plane& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The in-circle determinant: positive if d lies inside the circle through a, b, c (counter-clockwise).
double in_circle(const Plane& a, const Plane& b, const Plane& c, const Plane& d)
{
    const auto lift = [&](const Plane& p) {
        return std::array<double, 3>{p.x - d.x, p.y - d.y, (p.x - d.x) * (p.x - d.x) + (p.y - d.y) * (p.y - d.y)};
    };
    const auto u = lift(a);
    const auto v = lift(b);
    const auto w = lift(c);
    return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

bool is_delaunay(const std::vector<Plane>& all, uint32_t i, uint32_t j, uint32_t k)
{
    for (uint32_t m = 0; m < all.size(); ++m)
        if (m != i && m != j && m != k && in_circle(all[i], all[j], all[k], all[m]) > 1e-9) return false;
    return true;
}

using Corners = std::array<uint32_t, 3>;

// Every Delaunay triangle with a corner inside the cap.
std::set<Corners> delaunay_triangles()
{
    constexpr uint32_t kEnough = 120;
    std::vector<Plane> all;
    for (uint32_t i = 0; i < kEnough; ++i) all.push_back(pattern_point(i));
    std::set<Corners> found;
    for (uint32_t i = 0; i < static_cast<uint32_t>(polar::kReach); ++i) {
        for (uint32_t j = i + 1; j < kEnough; ++j) {
            for (uint32_t k = i + 1; k < kEnough; ++k)
                if (j != k && cross(all[i], all[j], all[k]) > 1e-9 && is_delaunay(all, i, j, k))
                    found.insert({i, j, k});
        }
    }
    return found;
}

}  // namespace

TEST_CASE("the polar triangles are the Delaunay triangles of the pattern", "[polar]")
{
    std::set<Corners> table;
    for (int k = 0; k < polar::kTriangles; ++k) {
        const uint8_t* c = polar::corners(k);
        REQUIRE(c[0] < polar::kPoints);
        REQUIRE(c[1] < polar::kPoints);
        REQUIRE(c[2] < polar::kPoints);
        table.insert({c[0], c[1], c[2]});
    }
    CHECK(table == delaunay_triangles());
}

TEST_CASE("the triangle beyond an edge shares it", "[polar]")
{
    for (int k = 0; k < polar::kWalkTriangles; ++k) {
        const uint8_t* c = polar::corners(k);
        for (int e = 0; e < 3; ++e) {
            const uint8_t next = polar::beyond(k)[e];
            if (next == polar::kNone) continue;
            REQUIRE(next < polar::kWalkTriangles);
            const uint8_t* n = polar::corners(next);
            const auto has = [&](uint8_t corner) { return n[0] == corner || n[1] == corner || n[2] == corner; };
            CHECK(has(c[(e + 1) % 3]));
            CHECK(has(c[(e + 2) % 3]));
            CHECK(!has(c[e]));
        }
    }
}

TEST_CASE("the polar pattern's points lie where Lambert's projection puts them", "[polar]")
{
    Worst worst;
    for (uint32_t i = 0; i < polar::kPoints; ++i) {
        const polar::PlanePoint p = polar::plane_point(i);
        const Plane truth = pattern_point(i);
        worst.see(std::hypot(p.x_q12 / 4096.0 - truth.x, p.y_q12 / 4096.0 - truth.y), i);
    }
    worst.report("polar pattern, distance from the projection");
    CHECK(worst.error < 1.0 / 4096);
}
