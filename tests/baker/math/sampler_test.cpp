// SPDX-License-Identifier: MIT
#include "math/sampler.h"

#include <catch2/catch.hpp>
#include <set>

#include "math/vec3.h"
#include "math/warp.h"
#include "support/statistics.h"

namespace lumi::baker
{
namespace
{

using testing::chi2_score;
using testing::kSigmas;

constexpr int kBins = 16;

size_t bin(const Vec2& u)
{
    return static_cast<size_t>(u.y * kBins) * kBins + static_cast<size_t>(u.x * kBins);
}

}  // namespace

TEST_CASE("sampler: numbers depend on seed, texel, sample and dimension, and on nothing else")
{
    std::set<float> seen;
    for (const uint64_t seed : {1u, 2u}) {
        for (const uint32_t i : {0u, 1u}) {
            for (const uint32_t j : {0u, 1u}) {
                Sampler a(seed, i, j), b(seed, i, j);
                for (const uint32_t s : {0u, 1u}) {
                    a.start(s);
                    b.start(s);
                    for (int d = 0; d < 40; ++d) {
                        const float x = a.next_1d();
                        CHECK(x == b.next_1d());
                        CHECK((x >= 0 && x < 1));
                        seen.insert(x);
                    }
                }
            }
        }
    }
    CHECK(seen.size() > 16 * 40 - 8);  // chance repeats of 24-bit numbers only
}

TEST_CASE("sampler: each pair of dimensions fills every elementary interval of its first 2^k samples once")
{
    for (const int k : {4, 6, 8}) {
        const uint32_t count = 1u << k;
        for (int columns_log = 0; columns_log <= k; ++columns_log) {
            std::set<std::pair<int, int>> cells;
            Sampler sampler(9, 3, 4);
            for (uint32_t s = 0; s < count; ++s) {
                sampler.start(s);
                sampler.next_1d();
                const Vec2 u = sampler.next_2d();
                cells.insert({static_cast<int>(u.x * static_cast<float>(1 << columns_log)),
                              static_cast<int>(u.y * static_cast<float>(1 << (k - columns_log)))});
            }
            INFO(count << " samples in " << (1 << columns_log) << " columns");
            CHECK(cells.size() == count);
        }
    }
}

TEST_CASE("sampler: the first sample of every texel is uniform, in stratified and in later dimensions")
{
    constexpr uint32_t kTexels = 40000;
    for (const int skipped : {0, 1, 10, 23, 24, 30}) {
        std::vector<double> counts(kBins * kBins), expected(kBins * kBins, kTexels / double{kBins * kBins});
        for (uint32_t j = 0; j < kTexels; ++j) {
            Sampler sampler(1, 5, j);
            sampler.start(0);
            for (int k = 0; k < skipped; ++k) sampler.next_2d();
            ++counts[bin(sampler.next_2d())];
        }
        INFO("after " << skipped << " dimensions");
        CHECK(chi2_score(counts, expected) < kSigmas);
    }
}

TEST_CASE("sampler: different dimensions of one texel are independent")
{
    std::vector<double> counts(kBins * kBins), expected(kBins * kBins, 64.0);
    for (uint32_t s = 0; s < 64 * kBins * kBins; ++s) {
        Sampler sampler(1, s / 16, 7);
        sampler.start(s % 16);
        const float first = sampler.next_1d();
        sampler.next_2d();
        ++counts[bin({first, sampler.next_2d().x})];
    }
    CHECK(chi2_score(counts, expected) < kSigmas);
}

TEST_CASE("warp: the unit square maps to the disc uniformly")
{
    constexpr uint32_t kSamples = 65536;
    std::vector<double> counts(kBins * kBins), expected(kBins * kBins, kSamples / double{kBins * kBins});
    for (uint32_t k = 0; k < kSamples; ++k) {
        const Vec2 d = square_to_disc(Sampler(2, k, 0).next_2d());
        const float radius2 = d.x * d.x + d.y * d.y;
        REQUIRE(radius2 <= 1.00001f);
        const float turn = std::atan2(d.y, d.x) / (2 * kPi) + 0.5f;
        ++counts[bin({std::min(radius2, 0.99999f), std::min(turn, 0.99999f)})];
    }
    CHECK(chi2_score(counts, expected) < kSigmas);
}

TEST_CASE("frame: orthonormal and right-handed for every normal, poles and the seam included")
{
    std::vector<Vec3> normals = {{0, 0, 1},     {0, 0, -1},     {1, 0, 0},    {0, 1, 0},
                                 {1, 0, -0.0f}, {1e-7f, 0, -1}, {0, 1e-4f, 1}};
    for (uint32_t k = 0; k < 2000; ++k) normals.push_back(square_to_sphere(Sampler(4, k, 0).next_2d()));
    double worst = 0;
    for (const Vec3& raw : normals) {
        const Vec3 n = normalized(raw);
        const Frame f(n);
        const Vec3 right_handed = cross(f.tangent, f.bitangent) - f.normal;
        for (const float e : {dot(f.tangent, f.bitangent), dot(f.tangent, n), dot(f.bitangent, n),
                              length(f.tangent) - 1, length(f.bitangent) - 1, length(right_handed)})
            worst = std::max(worst, std::abs(static_cast<double>(e)));
    }
    CHECK(worst < 1e-6);  // some rounding steps of binary32
}

TEST_CASE("warp: sine and cosine of turns are those of the C library")
{
    double worst = 0;
    for (int k = -20000; k <= 40000; ++k) {
        const float turns = static_cast<float>(k) / 10000;
        const double angle = 2 * M_PI * static_cast<double>(turns);
        const SineCosine s = sine_cosine_of_turns(turns);
        worst = std::max({worst, std::abs(static_cast<double>(s.sine) - std::sin(angle)),
                          std::abs(static_cast<double>(s.cosine) - std::cos(angle))});
    }
    INFO("worst error " << worst);
    CHECK(worst < 2.5e-7);
}

TEST_CASE("warp: the disc is filled evenly, up to its rim")
{
    constexpr int kSide = 200;
    double radius2 = 0, x = 0, y = 0, farthest = 0;
    for (int k = 0; k < kSide * kSide; ++k) {
        const Vec2 u = {(static_cast<float>(k % kSide) + 0.5f) / kSide, (static_cast<float>(k / kSide) + 0.5f) / kSide};
        const Vec2 d = square_to_disc(u);
        const double r2 = static_cast<double>(d.x * d.x + d.y * d.y);
        radius2 += r2 / kSide / kSide;
        x += static_cast<double>(d.x) / kSide / kSide;
        y += static_cast<double>(d.y) / kSide / kSide;
        farthest = std::max(farthest, r2);
    }
    CHECK(radius2 == Approx(0.5).epsilon(1e-3));
    CHECK(std::abs(x) < 1e-4);
    CHECK(std::abs(y) < 1e-4);
    CHECK(farthest == Approx(1).margin(0.02));
    CHECK(farthest <= 1);
}

}  // namespace lumi::baker
