// SPDX-License-Identifier: MIT
#include "chord/texel_tracer.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <vector>

#include "support/bake_scenes.h"

#include "math/sampler.h"
#include "support/statistics.h"

namespace lumi::baker
{
namespace
{

using testing::chi2_score;
using testing::kSigmas;

constexpr int kRings = 6, kSectors = 12;

// Counts of samples per equal-area cell of the disc, seen in a frame that the baker does not use: the tangent plane's
// east and north, or any pair at a pole.
std::vector<double> cells_of(const OriginDisc& disc, uint64_t seed, uint32_t origin, uint32_t samples)
{
    const Vec3 n = disc.frame.normal;
    const Vec3 axis = std::abs(n.z) < 0.9f ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 east = normalized(cross(axis, n));
    const Vec3 north = cross(n, east);
    std::vector<double> counts(kRings * kSectors);
    for (uint32_t k = 0; k < samples; ++k) {
        const Vec3 offset = disc.at(Sampler(seed, origin, k).next_2d()) - n;
        const float x = dot(offset, east) / disc.radius, y = dot(offset, north) / disc.radius;
        const float radius2 = std::min(x * x + y * y, 0.99999f);
        const float turn = std::min(std::atan2(y, x) / (2 * kPi) + 0.5f, 0.99999f);
        ++counts[static_cast<size_t>(radius2 * kRings) * kSectors + static_cast<size_t>(turn * kSectors)];
    }
    return counts;
}

// Coverage of every texel, row after row.
std::vector<int> coverages(const Scene& scene, const BakeSettings& settings)
{
    const TexelTracer tracer(scene.data(), settings);
    std::vector<int> result;
    for (uint32_t i = 0; i < settings.origins; ++i)
        for (uint32_t j = 0; j < settings.directions; ++j)
            result.push_back(tracer.estimate(tracer.disc(i), i, j).covered_colour().a);
    return result;
}

}  // namespace

TEST_CASE("field rays: starts lie in the tangent plane, on a disc of area 4π/M, for every origin")
{
    double worst_height = 0, worst_excess = 0;
    for (const uint32_t m : {1u, 2u, 3u, 64u, 1000u}) {
        const FieldRays rays(m, 1);
        for (uint32_t i = 0; i < m; ++i) {
            const OriginDisc disc = rays.disc(i);
            const double area = static_cast<double>(kPi * disc.radius * disc.radius);
            REQUIRE(area == Approx(4 * static_cast<double>(kPi) / m).epsilon(1e-6));
            for (uint32_t k = 0; k < 50; ++k) {
                const Vec3 offset = disc.at(Sampler(1, i, k).next_2d()) - disc.frame.normal;
                worst_height =
                    std::max(worst_height, static_cast<double>(std::abs(dot(offset, disc.frame.normal)) / disc.radius));
                worst_excess = std::max(worst_excess, static_cast<double>(length(offset) / disc.radius) - 1);
            }
        }
    }
    CHECK(worst_height < 1e-5);
    CHECK(worst_excess < 1e-5);
}

TEST_CASE("field rays: starts are uniform on the disc for every origin, poles included")
{
    constexpr uint32_t kOrigins = 200, kSamples = 4000;
    const FieldRays rays(kOrigins, 1);
    const std::vector<double> expected(kRings * kSectors, double{kSamples} / (kRings * kSectors));
    std::vector<double> total(kRings * kSectors);
    double worst = 0;
    uint32_t worst_origin = 0;
    for (uint32_t i = 0; i < kOrigins; ++i) {
        const std::vector<double> counts = cells_of(rays.disc(i), 3, i, kSamples);
        const double score = chi2_score(counts, expected);
        worst_origin = score > worst ? i : worst_origin;
        worst = std::max(worst, score);
        for (size_t k = 0; k < total.size(); ++k) total[k] += counts[k];
    }
    INFO("worst origin " << worst_origin);
    CHECK(worst < kSigmas);
    CHECK(chi2_score(total, std::vector<double>(total.size(), double{kSamples} * kOrigins / (kRings * kSectors))) <
          kSigmas);
}

TEST_CASE("field rays: the exact poles have sound discs too")
{
    for (const float z : {1.0f, -1.0f}) {
        const OriginDisc disc = {Frame({0, 0, z}), 0.1f};
        const std::vector<double> counts = cells_of(disc, 5, 0, 20000);
        CHECK(chi2_score(counts, std::vector<double>(counts.size(), 20000.0 / (kRings * kSectors))) < kSigmas);
    }
}

TEST_CASE("field rays: origins and directions are the points of core's lattice, and rays end at their target")
{
    const FieldRays rays(10, 20);
    for (uint32_t j = 0; j < 20; ++j) {
        const double z = 1 - (2.0 * j + 1) / 20;
        CHECK(static_cast<double>(rays.direction_point(j).z) == Approx(z).margin(1e-6));
    }
    CHECK(static_cast<double>(rays.disc(0).frame.normal.z) == Approx(0.9).margin(1e-6));

    const Vec3 start = {0, 0, 1}, target = {0, 0.6f, -0.8f};
    const std::optional<Ray> ray = FieldRays::ray(start, target);
    REQUIRE(ray);
    CHECK(static_cast<double>(length(ray->origin + ray->direction * ray->end - target)) < 1e-6);
    CHECK_FALSE(FieldRays::ray(start, start));
}

TEST_CASE("field rays: a parallel beam has one direction, from point to point, and no end")
{
    const FieldRays rays(10, 20);
    for (uint32_t i = 0; i < 10; ++i) {
        const OriginDisc disc = rays.disc(i);
        for (const Vec2& u : {Vec2{0.1f, 0.2f}, Vec2{0.9f, 0.7f}}) {
            const Vec3 start = disc.at(u), target = rays.direction_point(3);
            const std::optional<Ray> ray = FieldRays::parallel_ray(start, disc.frame.normal, target);
            REQUIRE(ray);
            CHECK(static_cast<double>(length(ray->origin - start)) == 0);
            CHECK(static_cast<double>(length(ray->direction - normalized(target - disc.frame.normal))) < 1e-6);
            CHECK(std::isinf(ray->end));
        }
    }
    CHECK_FALSE(FieldRays::parallel_ray({1, 0, 0}, {0, 0, 1}, {0, 0, 1}));
}

TEST_CASE("field rays: both beams see the same share of the scene, in other texels")
{
    // Over all origins and directions either beam covers the rays through the sphere about evenly.
    const Scene scene = testing::tiny_scene();
    BakeSettings settings;
    settings.origins = settings.directions = 64;
    settings.samples = 16;
    settings.beam = Beam::converging;
    const std::vector<int> converging = coverages(scene, settings);
    settings.beam = Beam::parallel;
    const std::vector<int> parallel = coverages(scene, settings);
    CHECK((converging != parallel));
    const double a = std::accumulate(converging.begin(), converging.end(), 0.0),
                 b = std::accumulate(parallel.begin(), parallel.end(), 0.0);
    CHECK(b == Approx(a).epsilon(0.1));
}

TEST_CASE("field rays: a footprint of a point is one ray, of the origin a disc at one end, of both a disc at each")
{
    // A texel is partly covered where its rays differ.
    const Scene scene = testing::tiny_scene();
    const auto mixed = [&](Footprint footprint) {
        BakeSettings settings;
        settings.origins = settings.directions = 32;
        settings.samples = 64;
        settings.max_error_levels = 0;
        settings.footprint = footprint;
        const std::vector<int> all = coverages(scene, settings);
        return std::count_if(all.begin(), all.end(), [](int a) { return a > 0 && a < 255; });
    };
    const auto point = mixed(Footprint::point), origin = mixed(Footprint::origin), both = mixed(Footprint::both);
    CHECK(point == 0);
    CHECK(origin > 100);
    CHECK(both > origin + origin / 10);
}

}  // namespace lumi::baker
