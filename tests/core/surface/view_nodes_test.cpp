// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/view_nodes.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "twin.h"

using namespace lumi;
using namespace lumi::detail;
using twin::Vec3;

namespace
{

constexpr double kScale = 30000;
#ifdef LUMI_TEST_LIGHT
constexpr int kDirections = 2000;
#else
constexpr int kDirections = 100000;
#endif

Vec3 node(uint32_t k)
{
    const double z = 1 - (2.0 * k + 1) / format::kViewLattice, r = std::sqrt(1 - z * z);
    const double longitude = 2 * twin::kPi * std::fmod(k * 0.61803398874989485, 1.0);
    return {r * std::cos(longitude), r * std::sin(longitude), z};
}

ViewTaps taps_at(const Vec3& d, double scale = kScale)
{
    const auto q = [&](double v) { return static_cast<int32_t>(std::lround(v * scale)); };
    return view_taps(q(d.x), q(d.y), q(d.z));
}

// Anywhere at or above a height.
Vec3 random_direction(std::minstd_rand& random, double lowest)
{
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 32>(random);
    };
    const double z = uniform(lowest, 1), angle = uniform(0, 2 * twin::kPi), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

Vec3 mean_of_nodes(const ViewTaps& taps)
{
    Vec3 sum = {0, 0, 0};
    for (int m = 0; m < 3; ++m) sum = sum + (taps.weight_q8[m] / 256.0) * node(taps.node[m]);
    return twin::normalised(sum);
}

double degrees_between(const Vec3& a, const Vec3& b)
{
    return std::acos(std::fmin(1.0, dot(a, b))) * 180 / twin::kPi;
}

// The largest change of any node's weight.
int largest_change(const ViewTaps& a, const ViewTaps& b)
{
    int change[format::kViewNodes] = {};
    for (int m = 0; m < 3; ++m) {
        change[a.node[m]] += a.weight_q8[m];
        change[b.node[m]] -= b.weight_q8[m];
    }
    int largest = 0;
    for (const int c : change) largest = std::max(largest, std::abs(c));
    return largest;
}

}  // namespace

TEST_CASE("every direction lies between nodes of a view table")
{
    std::minstd_rand random(1);
    int wrong = 0;
    for (int k = 0; k < kDirections; ++k) {
        const ViewTaps taps = taps_at(random_direction(random, -1), std::pow(2.0, 1 + random() % 15));
        wrong += taps.weight_q8[0] + taps.weight_q8[1] + taps.weight_q8[2] != 256 ? 1 : 0;
        for (const uint8_t n : taps.node) wrong += n >= format::kViewNodes ? 1 : 0;
    }
    const ViewTaps nowhere = view_taps(0, 0, 0);
    wrong += nowhere.weight_q8[0] + nowhere.weight_q8[1] + nowhere.weight_q8[2] != 256 ? 1 : 0;
    CHECK(wrong == 0);
}

TEST_CASE("a node's own direction has all of its weight")
{
    for (uint32_t k = 0; k < format::kViewNodes; ++k) {
        const ViewTaps taps = taps_at(node(k));
        uint32_t weight = 0;
        for (int m = 0; m < 3; ++m) weight += taps.node[m] == k ? taps.weight_q8[m] : 0;
        CAPTURE(k);
        CHECK(weight >= 250);
    }
}

TEST_CASE("nodes around a direction stand for it")
{
    std::minstd_rand random(2);
    double worst = 0, sum = 0;
    for (int k = 0; k < kDirections; ++k) {
        const Vec3 d = random_direction(random, 0);
        const double off = degrees_between(mean_of_nodes(taps_at(d)), d);
        worst = std::max(worst, off);
        sum += off;
    }
    CHECK(worst < 14);
    CHECK(sum / kDirections < 2);
}

TEST_CASE("weights of nodes change little with the direction")
{
    std::minstd_rand random(3);
    int worst = 0;
    for (int k = 0; k < kDirections; ++k) {
        const Vec3 d = random_direction(random, 0.2);
        const Vec3 step = 1e-3 * random_direction(random, -1);
        worst = std::max(worst, largest_change(taps_at(d), taps_at(twin::normalised(d + step))));
    }
    CHECK(worst <= 16);
}

TEST_CASE("half a turn takes a vertex's direction to the pole")
{
    std::minstd_rand random(4);
    double worst = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3 normal = random_direction(random, -0.999);
        const Vec3 h = twin::normalised(normal + Vec3{0, 0, 1});
        const auto s8 = [](double v) { return static_cast<int32_t>(std::lround(v * 127)); };
        const auto q = [](double v) { return static_cast<int32_t>(std::lround(v * kScale)); };
        const ViewDirection d = in_view_frame({q(normal.x), q(normal.y), q(normal.z)}, s8(h.x), s8(h.y), s8(h.z));
        const Vec3 turned =
            twin::normalised(Vec3{static_cast<double>(d.x), static_cast<double>(d.y), static_cast<double>(d.z)});
        worst = std::max(worst, degrees_between(turned, {0, 0, 1}));
    }
    CHECK(worst < 2);
}
