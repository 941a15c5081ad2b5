// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <vector>

#include "lattice/directions.h"
#include "lumi/detail/lattice.h"
#include "twin.h"

using namespace lumi;
using namespace lumi::detail;
using test::Directions;
using twin::Vec3;
using twin::Weights;

namespace
{

constexpr uint32_t kLargeSizes[] = {377, 1000, 4096, 24576, 65536, 1u << 20};

template <class Visit>
void for_sizes(Visit visit)
{
#ifdef LUMI_TEST_LIGHT
    for (const uint32_t n : {3u, 4u, 12u, 40u, 63u, 64u, 100u, 1024u}) visit(n);
#else
    for (uint32_t n = 1; n <= 300; ++n) visit(n);
    for (const uint32_t n : kLargeSizes) visit(n);
#endif
}

Weights of(const Triangle& t)
{
    Weights weights;
    for (int m = 0; m < 3; ++m) weights.emplace_back(t.index[m], t.weight_q12[m] / static_cast<double>(kWeightOneQ12));
    return weights;
}

// By how many levels of 255 two sums of texels can differ, whatever the texels hold.
double levels(const Weights& a, const Weights& b)
{
    std::map<uint32_t, double> change;
    for (const auto& [i, w] : a) change[i] += w;
    for (const auto& [i, w] : b) change[i] -= w;
    double sum = 0;
    for (const auto& [i, w] : change) sum += std::fabs(w);
    return 255 * sum / 2;
}

struct WorstPlace {
    double levels = 0;
    uint32_t n = 0;
    Vec3 at = {0, 0, 1};

    void see(double l, uint32_t size, const Vec3& q)
    {
        if (l > levels) *this = {l, size, q};
    }

    void report(const char* what) const
    {
        std::printf("%s: worst %.3g levels, n %u, index %.4f from the pole, longitude %.5f turns, z %.6f\n", what,
                    levels, static_cast<unsigned>(n), n * (1 - std::fabs(at.z)) / 2 - 0.5,
                    std::atan2(at.y, at.x) / (2 * twin::kPi), at.z);
    }
};

// A straight way over the sphere.
struct Way {
    Vec3 from, step;
    Vec3 at(double s) const { return twin::normalised(from + s * step); }
};

// The step of at most `shortest` within [begin, end] of a way where weights change most, found by halving.
template <class WeightsAt>
void see_steepest(const Way& way, double begin, double end, double shortest, const WeightsAt& weights_at, uint32_t n,
                  WorstPlace& worst)
{
    Weights first = weights_at(way.at(begin)), last = weights_at(way.at(end));
    while (end - begin > shortest) {
        const double middle = (begin + end) / 2;
        const Weights between = weights_at(way.at(middle));
        const bool is_in_first = levels(first, between) > levels(between, last);
        (is_in_first ? end : begin) = middle;
        (is_in_first ? last : first) = between;
    }
    worst.see(levels(first, last), n, way.at(begin));
}

// Where ways begin: at poles, where the polar plane goes over into longitude and height and where it was switched once,
// at the equator, where zones and cells meet, and anywhere.
Vec3 start(Directions& directions, uint32_t n, uint32_t k)
{
    switch (k % 8) {
        case 0:
            return directions.on_ring(20 + directions.uniform() - 0.5);
        case 1:
            return directions.on_ring(21 + directions.uniform() - 0.5);
        case 2:
            return directions.on_ring(24 + directions.uniform() - 0.5);
        case 3:
            return Directions::at((directions.uniform() - 0.5) * twin::spacing(n) / 4, directions.uniform());
        default:
            return directions.next(k / 8);
    }
}

// Walks `ways` ways of a third of a spacing and sees the largest change over a step of 1e-4 spacings.
template <class WeightsAt>
void walk(uint32_t n, uint32_t ways, const WeightsAt& weights_at, WorstPlace& worst)
{
    constexpr double kStep = 1e-4;
    constexpr int kParts = 16;
    Directions directions(n);
    for (uint32_t k = 0; k < ways; ++k) {
        const Vec3 from = start(directions, n, k);
        const Vec3 to = directions.anywhere();
        const Vec3 step = to - twin::dot(to, from) * from;
        if (twin::length(step) == 0) continue;
        const double part = twin::spacing(n) / 3 / kParts;
        const Way way = {from, twin::normalised(step)};
        for (int p = 0; p < kParts; ++p)
            see_steepest(way, p * part, (p + 1) * part, kStep * twin::spacing(n), weights_at, n, worst);
    }
}

uint32_t ways_for(uint32_t n)
{
#ifdef LUMI_TEST_LIGHT
    return n <= 300 ? 2 : 4;
#else
    return n <= 300 ? 48 : 800;
#endif
}

}  // namespace

TEST_CASE("no step of 1/10,000 spacing changes a linear picture by more than a level", "[triangle]")
{
    WorstPlace worst;
    for_sizes([&](uint32_t n) {
        const Lattice lattice(n);
        walk(
            n, ways_for(n), [&](const Vec3& q) { return of(triangle(lattice, twin::encoded(q))); }, worst);
    });
    worst.report("linear weights, change over a step of 1/10,000 spacing");
    // 0.05 levels of slope, the rest is rounding to 1/4096.
    CHECK(worst.levels < 0.5);
}

TEST_CASE("linear weights are those of the twin, for every size", "[triangle]")
{
    WorstPlace worst;
    for_sizes([&](uint32_t n) {
        const Lattice lattice(n);
        const std::vector<Vec3> all = twin::points(n);
        Directions directions(n);
        for (uint32_t k = 0; k < ways_for(n); ++k) {
            const Vec3 q = twin::normalised(start(directions, n, k));
            worst.see(levels(of(triangle(lattice, twin::encoded(q))), twin::linear_weights(all, q)), n, q);
        }
    });
    worst.report("linear weights, difference from the twin");
    CHECK(worst.levels < 0.5);
}

#ifndef LUMI_TEST_LIGHT  // the twin is the same on every machine
TEST_CASE("the twin's linear weights are continuous, and a switch of maps on a ring would show", "[triangle]")
{
    const uint32_t n = GENERATE(3u, 12u, 30u, 63u, 64u, 100u, 256u, 1000u);
    const std::vector<Vec3> all = twin::points(n);
    const uint32_t ways = 64;
    WorstPlace worst, switched, from_core;
    walk(
        n, ways, [&](const Vec3& q) { return twin::linear_weights(all, q); }, worst);
    worst.report("the twin's linear weights, change over a step of 1/10,000 spacing");
    CHECK(worst.levels < 0.1);  // the slope: 3 points, linear from pole to pole, have the steepest
    if (n < 64) return;

    // The fault that was in core once: one map below index 21, the other one above.
    const auto with_switch = [&](const Vec3& q) { return twin::linear_weights(all, q, {21, 21}); };
    walk(n, ways, with_switch, switched);
    CHECK(switched.levels > 10);
    const Lattice lattice(n);
    Directions directions(n);
    for (uint32_t k = 0; k < 4000; ++k) {
        const Vec3 q = start(directions, n, k);
        from_core.see(levels(of(triangle(lattice, twin::encoded(q))), with_switch(q)), n, q);
    }
    CHECK(from_core.levels > 10);
}
#endif

TEST_CASE("a triangle's corners surround the query and reproduce its position", "[triangle]")
{
    // A linear function is reproduced up to the curvature of the sphere over one triangle.
    double error = 0;
    for_sizes([&](uint32_t n) {
        if (n < 64) return;
        const Lattice lattice(n);
        Directions directions(n);
        for (uint32_t k = 0; k < 10 * ways_for(n); ++k) {
            const Vec3 q = directions.next(k);
            const Triangle t = triangle(lattice, twin::encoded(q));
            uint32_t sum = 0;
            Vec3 mean = {0, 0, 0};
            for (int m = 0; m < 3; ++m) {
                REQUIRE(t.index[m] < n);
                sum += t.weight_q12[m];
                mean = mean + (t.weight_q12[m] / 4096.0) * twin::point(n, t.index[m]);
            }
            REQUIRE(sum == kWeightOneQ12);
            error = std::max(error, twin::length(mean - q) / twin::spacing(n));
        }
    });
    std::printf("triangle, error of the reproduced position: worst %.3g spacings\n", error);
    CHECK(error < 0.25);
}
