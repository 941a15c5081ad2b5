// SPDX-License-Identifier: MIT
#include "lumi/detail/lattice.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "lattice/directions.h"
#include "report.h"
#include "twin.h"

using namespace lumi;
using namespace lumi::detail;
using test::Directions;
using twin::Vec3;

namespace
{

// Distances of two lattice points may differ by this share of the mean spacing before the wrong one is called wrong:
// distances are compared in units between 2^-12 and 2^-11 of it, and three squares round.
constexpr double kTolerance = 1.0 / 512;

// The squares of the distances to the nearest points, kMaxNeighbours of them where there are so many.
std::vector<double> nearest_squares(const std::vector<Vec3>& all, const Vec3& q)
{
    std::vector<double> squares;
    squares.reserve(all.size());
    for (const Vec3& p : all) squares.push_back(twin::dot(p - q, p - q));
    const size_t wanted = std::min<size_t>(kMaxNeighbours, all.size());
    std::partial_sort(squares.begin(), squares.begin() + static_cast<std::ptrdiff_t>(wanted), squares.end());
    squares.resize(wanted);
    return squares;
}

// How far the k-th found neighbour is beyond the k-th true one, as a share of the spacing; the largest over k.
double excess(const Lattice& lattice, const std::vector<Vec3>& all, const Vec3q30& query,
              const std::vector<double>& truth, uint32_t count)
{
    const Vec3 q = twin::decoded(query);
    const uint32_t expected = std::min<uint32_t>(count, lattice.size());
    Neighbour found[kMaxNeighbours];
    if (neighbours(lattice, query, count, found) != expected) return INFINITY;
    double worst = 0;
    for (uint32_t k = 0; k < expected; ++k) {
        for (uint32_t m = 0; m < k; ++m)
            if (found[m].index == found[k].index) return INFINITY;
        const double distance = twin::length(all[found[k].index] - q);
        worst = std::max(worst, (distance - std::sqrt(truth[k])) / twin::spacing(lattice.size()));
    }
    return worst;
}

void sweep(uint32_t n, uint32_t queries, const std::vector<uint32_t>& counts, Worst& worst)
{
    const Lattice lattice(n);
    const std::vector<Vec3> all = twin::points(n);
    Directions directions(n);
    for (uint32_t k = 0; k < queries; ++k) {
        const Vec3q30 query = twin::encoded(directions.next(k));
        const std::vector<double> truth = nearest_squares(all, twin::decoded(query));
        for (const uint32_t count : counts)
            worst.see(excess(lattice, all, query, truth, count), uint64_t{n} * 1000000 + k);
    }
}

#ifdef LUMI_TEST_LIGHT
constexpr uint32_t kSmallSizes[] = {1, 2, 3, 4, 5, 7, 12, 63, 64, 65, 100, 300};
constexpr uint32_t kLargeSizes[] = {1024};
constexpr uint32_t kSmallQueries = 30;
constexpr uint32_t kLargeQueries = 60;
#else
constexpr uint32_t kLargeSizes[] = {377,   500,   610,   1000,   1024,   2048,    4096,
                                    10007, 24576, 65536, 131071, 262144, 1000003, 1u << 20};
constexpr uint32_t kSmallQueries = 400;
constexpr uint32_t kLargeQueries = 600;
#endif

template <class Visit>
void for_sizes(Visit visit)
{
#ifdef LUMI_TEST_LIGHT
    for (const uint32_t n : kSmallSizes) visit(n, kSmallQueries);
#else
    for (uint32_t n = 1; n <= 300; ++n) visit(n, kSmallQueries);
#endif
    for (const uint32_t n : kLargeSizes) visit(n, kLargeQueries);
}

}  // namespace

TEST_CASE("points lie where the definition says, for every size", "[lattice]")
{
    Worst worst;
    for_sizes([&](uint32_t n, uint32_t) {
        const Lattice lattice(n);
        const uint32_t step = std::max<uint32_t>(1, n / 20000);
        for (uint32_t i = 0; i < n; i += step)
            worst.see(twin::length(twin::decoded(point(lattice, i)) - twin::point(n, i)), uint64_t{n} * 2000000 + i);
    });
    worst.report("point, distance from the definition");
    CHECK(worst.error < std::ldexp(1.0, -22));
}

TEST_CASE("every point is its own nearest", "[lattice]")
{
    uint32_t wrong = 0;
    for_sizes([&](uint32_t n, uint32_t) {
        const Lattice lattice(n);
        const uint32_t step = std::max<uint32_t>(1, n / 2000);
        for (uint32_t i = 0; i < n; i += step) wrong += nearest(lattice, point(lattice, i)) != i;
    });
    CHECK(wrong == 0);
}

TEST_CASE("the nearest 1 to 9 neighbours agree with brute force", "[lattice]")
{
    Worst worst;
    for_sizes([&](uint32_t n, uint32_t queries) { sweep(n, queries, {1, 2, 3, 4, 5, 6, 7, 8, 9}, worst); });
    worst.report("neighbours, excess distance in spacings");
    CHECK(worst.error < kTolerance);
}

TEST_CASE("kernel weights sum to one and fall with distance", "[lattice]")
{
    bool sums = true;
    bool falls = true;
    for_sizes([&](uint32_t n, uint32_t queries) {
        const Lattice lattice(n);
        Directions directions(n);
        for (uint32_t k = 0; k < queries; ++k) {
            Neighbour near[kMaxNeighbours];
            uint32_t weight[kMaxNeighbours];
            const uint32_t count = neighbours(lattice, twin::encoded(directions.next(k)), 1 + k % 9, near);
            kernel_weights(lattice, near, count, weight);
            uint32_t sum = 0;
            for (uint32_t m = 0; m < count; ++m) sum += weight[m];
            for (uint32_t m = 1; m < count; ++m) falls = falls && weight[m] <= weight[m - 1];
            sums = sums && sum == kWeightOneQ12;
        }
    });
    CHECK(sums);
    CHECK(falls);
}
