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

// A point farther than the nearest by this share of the mean spacing is a wrong one.
constexpr double kWrong = 1e-3;
// Distances are rounded to a unit between 2^-14 and 2^-13 of the spacing, as their terms are before.
constexpr double kDistanceTolerance = 1e-3;
// Bounds the error of all weights of a query: those of nine taps are rounded down to 2^-12, and distances before by
// their part.
constexpr double kWeightTolerance = 1.0 / 400;

struct Found {
    std::vector<Neighbour> near;
    uint32_t weight_q12[kMaxNeighbours] = {};
};

Found find(const Lattice& lattice, const Vec3q30& query, uint32_t count)
{
    Found found;
    found.near.resize(count);
    found.near.resize(kernel_points(lattice, query, count, found.near.data()));
    kernel_weights(lattice, found.near.data(), static_cast<uint32_t>(found.near.size()), found.weight_q12);
    return found;
}

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

// Sums how far the kernel's weights are from the true ones, nearest first; points that only one has count in full.
double weight_error(const Found& found, const std::vector<double>& squares, uint32_t n)
{
    std::vector<double> truth;
    double sum = 0, error = 0;
    for (const double square : squares) {
        truth.push_back(std::pow(std::fmax(0.0, 1 - square * n / (4 * twin::kPi)), 2));
        sum += truth.back();
    }
    for (size_t k = 0; k < std::max(truth.size(), found.near.size()); ++k) {
        const double mine = k < found.near.size() ? found.weight_q12[k] / static_cast<double>(kWeightOneQ12) : 0;
        error += std::fabs(mine - (k < truth.size() ? truth[k] / sum : 0));
    }
    return error;
}

// How far a distance that was found is from the true one, as a share of the spacing; the largest over all found.
double distance_error(const Lattice& lattice, const std::vector<Vec3>& all, const Found& found, const Vec3& q)
{
    double worst = 0;
    for (const Neighbour& n : found.near) {
        const double units = std::sqrt(static_cast<double>(n.distance2));
        const double error = std::ldexp(units, -lattice.unit_bits()) - twin::length(all[n.index] - q);
        worst = std::max(worst, std::fabs(error) / twin::spacing(lattice.size()));
    }
    return worst;
}

template <class Visit>
void for_queries(uint32_t n, uint32_t queries, Visit visit)
{
    Directions directions(n);
    for (uint32_t k = 0; k < queries; ++k) {
        const Vec3q30 query = twin::encoded(directions.next(k));
        visit(query, twin::decoded(query), uint64_t{n} * 1000000 + k);
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

TEST_CASE("the nearest point and the kernel's points and weights agree with brute force", "[lattice]")
{
    Worst excess, weights, distances;
    for_sizes([&](uint32_t n, uint32_t queries) {
        const Lattice lattice(n);
        const std::vector<Vec3> all = twin::points(n);
        for_queries(n, queries, [&](const Vec3q30& query, const Vec3& q, uint64_t place) {
            const std::vector<double> squares = nearest_squares(all, q);
            const double distance = twin::length(all[nearest(lattice, query)] - q);
            excess.see((distance - std::sqrt(squares[0])) / twin::spacing(n), place);
            const Found found = find(lattice, query, kMaxNeighbours);
            weights.see(weight_error(found, squares, n), place);
            distances.see(distance_error(lattice, all, found, q), place);
        });
    });
    excess.report("nearest, excess distance in spacings");
    weights.report("kernel weights, sum of errors");
    distances.report("kernel points, error of distance in spacings");
    CHECK(excess.error < kWrong);
    CHECK(weights.error < kWeightTolerance);
    CHECK(distances.error < kDistanceTolerance);
}

TEST_CASE("fewer points of the kernel are the nearest of all", "[lattice]")
{
    uint32_t wrong = 0;
    for_sizes([&](uint32_t n, uint32_t queries) {
        const Lattice lattice(n);
        for_queries(n, queries, [&](const Vec3q30& query, const Vec3&, uint64_t) {
            const Found all = find(lattice, query, kMaxNeighbours);
            for (uint32_t count = 1; count < kMaxNeighbours; ++count) {
                const Found some = find(lattice, query, count);
                const size_t expected = std::min<size_t>(count, all.near.size());
                wrong += some.near.size() != expected;
                for (size_t k = 0; k < expected; ++k) wrong += some.near[k].distance2 != all.near[k].distance2;
            }
        });
    });
    CHECK(wrong == 0);
}

TEST_CASE("kernel weights sum to one and fall with distance", "[lattice]")
{
    bool sums = true;
    bool falls = true;
    for_sizes([&](uint32_t n, uint32_t queries) {
        const Lattice lattice(n);
        for_queries(n, queries, [&](const Vec3q30& query, const Vec3&, uint64_t place) {
            const Found found = find(lattice, query, 1 + static_cast<uint32_t>(place % kMaxNeighbours));
            uint32_t sum = found.weight_q12[0];
            for (size_t m = 1; m < found.near.size(); ++m) {
                sum += found.weight_q12[m];
                falls = falls && found.weight_q12[m] <= found.weight_q12[m - 1];
            }
            sums = sums && sum == kWeightOneQ12;
        });
    });
    CHECK(sums);
    CHECK(falls);
}
