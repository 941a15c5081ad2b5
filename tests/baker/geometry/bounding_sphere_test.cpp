// SPDX-License-Identifier: MIT
#include "geometry/bounding_sphere.h"

#include <catch2/catch.hpp>

#include "math/sampler.h"
#include "math/warp.h"

namespace lumi::baker
{
namespace
{

double distance(const Vec3& p, const BoundingSphere& s)
{
    const double x = static_cast<double>(p.x) - s.centre[0], y = static_cast<double>(p.y) - s.centre[1],
                 z = static_cast<double>(p.z) - s.centre[2];
    return std::sqrt(x * x + y * y + z * z);
}

void check(const std::vector<Vec3>& points, double radius)
{
    const BoundingSphere s = smallest_sphere(points);
    double farthest = 0;
    for (const Vec3& p : points) farthest = std::max(farthest, distance(p, s));
    CHECK(farthest <= s.radius);
    CHECK(s.radius == Approx(radius).epsilon(1e-5).margin(1e-12));
}

}  // namespace

TEST_CASE("bounding sphere: known smallest spheres")
{
    check({{1, 2, 3}}, 0);
    check({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, 0);
    check({{0, 0, 0}, {2, 0, 0}}, 1);
    check({{0, 0, 0}, {2, 0, 0}, {1, 0.5f, 0}}, 1);  // obtuse: two points carry it
    check({{1, 0, 0}, {-0.5f, 0.8660254f, 0}, {-0.5f, -0.8660254f, 0}}, 1);
    check({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, std::sqrt(3.0));
    std::vector<Vec3> cube;
    for (int k = 0; k < 8; ++k) cube.push_back({k & 1 ? 1.0f : 0, k & 2 ? 1.0f : 0, k & 4 ? 1.0f : 0});
    check(cube, std::sqrt(3.0) / 2);
}

TEST_CASE("bounding sphere: points on and in a sphere, at any scale and place")
{
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
        for (const float shift : {0.0f, 30.0f}) {
            std::vector<Vec3> points;
            for (uint32_t k = 0; k < 5000; ++k) {
                Sampler sampler(1, k, 0);
                const Vec3 d = square_to_sphere(sampler.next_2d());
                points.push_back((d * (k % 2 ? 1.0f : sampler.next_1d()) + Vec3{shift, 0, 0}) * scale);
            }
            INFO("scale " << scale << ", shift " << shift);
            check(points, static_cast<double>(scale));
        }
    }
}

TEST_CASE("bounding sphere: no four points of a random cloud need a larger one, and none outside is left")
{
    for (uint32_t cloud = 0; cloud < 50; ++cloud) {
        std::vector<Vec3> points;
        for (uint32_t k = 0; k < 200; ++k) {
            Sampler sampler(2, cloud, k);
            const Vec2 u = sampler.next_2d();
            points.push_back({u.x * 3, u.y, sampler.next_1d() * 0.2f});
        }
        const BoundingSphere s = smallest_sphere(points);
        // Optimal if the points on the surface cannot all be moved inwards: every half space through the centre holds
        // one.
        std::vector<Vec3> carriers;
        for (const Vec3& p : points) {
            REQUIRE(distance(p, s) <= s.radius * (1 + 1e-12));
            if (distance(p, s) > s.radius * (1 - 1e-5)) {
                carriers.push_back(p - Vec3{static_cast<float>(s.centre[0]), static_cast<float>(s.centre[1]),
                                            static_cast<float>(s.centre[2])});
            }
        }
        for (uint32_t k = 0; k < 500; ++k) {
            const Vec3 d = square_to_sphere(Sampler(3, cloud, k).next_2d());
            float most = -1;
            for (const Vec3& c : carriers) most = std::max(most, dot(c, d));
            CHECK(most > -1e-3f);
        }
    }
}

}  // namespace lumi::baker
