// SPDX-License-Identifier: MIT
// Flights through a medium against closed forms and quadrature.
#include <catch2/catch.hpp>

#include "support/statistics.h"
#include "support/volumes.h"
#include "volume/medium.h"

namespace lumi::baker
{
namespace
{

using testing::kSigmas;
using testing::Mean;

// A frame that is turned, moved and three times as large as the volume's own.
const Affine kTurnedGrid = {{{0, 3, 0, 0.1}, {1.8, 0, -2.4, 0.2}, {-2.4, 0, -1.8, -0.3}}};
constexpr double kTurnedRadius = 3;

Vec3 out_of(const Affine& m, const Vec3& p)
{
    const auto w = point_of(m, static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
    return {static_cast<float>(w[0]), static_cast<float>(w[1]), static_cast<float>(w[2])};
}

Vec3 into(const Affine& m, const Vec3& p)
{
    return out_of(inverse(m), p);
}

// Between two points of the volume's own frame, in the other.
Ray ray_between(const Affine& frame, const Vec3& from, const Vec3& to)
{
    const Vec3 a = into(frame, from), b = into(frame, to);
    return {a, normalized(b - a), length(b - a)};
}

// An own reading of grid and transfer function, in double precision.
double density_of(const Volume& volume, const Vec3& p)
{
    const auto v = point_of(inverse(volume.grid.voxel_to_world), static_cast<double>(p.x), static_cast<double>(p.y),
                            static_cast<double>(p.z));
    const uint32_t sizes[3] = {volume.grid.nx, volume.grid.ny, volume.grid.nz};
    double scalar = 0;
    for (size_t k = 0; k < 3; ++k)
        if (v[k] < 0 || v[k] > sizes[k] - 1) return 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        size_t place = 0;
        for (size_t k = 3; k-- > 0;) {
            const double cell = std::min(std::floor(v[k]), static_cast<double>(sizes[k] - 2));
            const int bit = corner >> k & 1;
            weight *= bit != 0 ? v[k] - cell : 1 - (v[k] - cell);
            place = place * sizes[k] + static_cast<size_t>(cell) + static_cast<size_t>(bit);
        }
        scalar += weight * static_cast<double>(volume.grid.values[place]);
    }
    const auto& points = volume.transfer.points();
    if (scalar <= static_cast<double>(points.front().value)) return static_cast<double>(points.front().density);
    for (size_t k = 1; k < points.size(); ++k) {
        const double a = static_cast<double>(points[k - 1].value), b = static_cast<double>(points[k].value);
        if (scalar <= b) {
            const double from = static_cast<double>(points[k - 1].density);
            return from + (static_cast<double>(points[k].density) - from) * (scalar - a) / (b - a);
        }
    }
    return static_cast<double>(points.back().density);
}

// Optical depth between two points.
double depth_between(const Volume& volume, const Vec3& from, const Vec3& to)
{
    constexpr int kSteps = 4000;
    double sum = 0;
    for (int k = 0; k < kSteps; ++k)
        sum += density_of(volume, from + (to - from) * ((static_cast<float>(k) + 0.5f) / kSteps));
    return sum * static_cast<double>(length(to - from)) / kSteps;
}

struct Flights {
    Mean passed, through, half;  // by flights, by ratios, by flights to the middle
};

Flights fly(const Medium& medium, const Ray& ray, uint32_t count)
{
    Flights result;
    for (uint32_t k = 0; k < count; ++k) {
        Sampler sampler(3, k, 0);
        const std::optional<float> stop = medium.collision(ray, sampler);
        result.passed.add(stop ? 0 : 1);
        result.half.add(stop && *stop < ray.end / 2 ? 0 : 1);
        result.through.add(static_cast<double>(medium.transmittance(ray, sampler)));
    }
    return result;
}

void check_exact_mean(const Mean& mean, double expected)
{
    INFO(mean.value() << " for " << expected << " +- " << mean.error());
    CHECK(std::abs(mean.value() - expected) <= kSigmas * mean.error() + 2e-6);
}

}  // namespace

TEST_CASE("flight: through fog what passes falls by Beer and Lambert's law")
{
    for (const float density : {0.2f, 2.0f, 9.0f}) {
        const Volume volume = testing::fog(density, grey(1), {-0.5f, -0.4f, -0.3f}, {0.5f, 0.4f, 0.3f});
        const Medium medium(volume, kTurnedGrid, kTurnedRadius);
        // From outside to outside, straight through the middle; the slanted way meets two neighbouring faces.
        const auto passing = [&](const Vec3& from, const Vec3& to, double inside) {
            const Flights flights = fly(medium, ray_between(kTurnedGrid, from, to), 20000);
            INFO("density " << density);
            check_exact_mean(flights.passed, std::exp(-static_cast<double>(density) * inside));
            check_exact_mean(flights.through, std::exp(-static_cast<double>(density) * inside));
        };
        passing({-2, 0.1f, 0.05f}, {1.3f, 0.1f, 0.05f}, 1);
        passing({-0.2f, -0.5f, 0.7f}, {-0.2f, 0.5f, -0.3f}, std::sqrt(2.0) * 0.5);
        passing({-0.2f, 0.3f, 0}, {0.3f, 0.3f, 0}, 0.5);
    }
}

TEST_CASE("flight: through smoke what passes is what quadrature says, to the end and to the middle")
{
    const Volume volume = testing::smoke();
    const Medium medium(volume, kTurnedGrid, kTurnedRadius);
    double least = 1;
    for (uint32_t r = 0; r < 12; ++r) {
        Sampler aim(6, r, 0);
        const Vec3 from = square_to_sphere(aim.next_2d()) * 0.9f;
        const Vec3 to = from * -0.9f + square_to_sphere(aim.next_2d()) * 0.3f;
        const Flights flights = fly(medium, ray_between(kTurnedGrid, from, to), 10000);
        const double expected = std::exp(-depth_between(volume, from, to));
        check_exact_mean(flights.passed, expected);
        check_exact_mean(flights.through, expected);
        check_exact_mean(flights.half, std::exp(-depth_between(volume, from, (from + to) * 0.5f)));
        least = std::min(least, expected);
    }
    CHECK(least < 0.3);
}

TEST_CASE("flight: rays beside the grid, before it and away from it meet nothing")
{
    const Medium medium(testing::fog(1e6f, grey(1), {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}),
                        {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}, 1);
    Sampler sampler(1, 0, 0);
    for (const Ray& ray : {Ray{{-1, 0.501f, 0}, {1, 0, 0}}, Ray{{-1, 0, 0}, {1, 0, 0}, 0.499f},
                           Ray{{-1, 0, 0}, {-1, 0, 0}}, Ray{{0, 0, 0.6f}, {0.6f, 0.8f, 0}}}) {
        CHECK_FALSE(medium.collision(ray, sampler));
        CHECK(medium.transmittance(ray, sampler) == 1);
    }
    CHECK(medium.collision({{-1, 0.499f, 0}, {1, 0, 0}}, sampler));
    CHECK(medium.transmittance({{-1, 0, 0}, {1, 0, 0}, 0.6f}, sampler) == 0);
    CHECK(medium.density({0.51f, 0, 0}) == 0);
    CHECK(medium.density({0.49f, 0, 0}) == 1e6f);
}

TEST_CASE("phase function: its density integrates to one, has mean cosine g, and is that of its samples")
{
    for (const float g : {-0.7f, 0.0f, 0.0005f, 0.3f, 0.9f}) {
        const Phase phase(g);
        constexpr int kSteps = 200000;
        double sum = 0, cosine_sum = 0;
        std::vector<double> counts(20), expected(20);
        for (int k = 0; k < kSteps; ++k) {
            const double c = (k + 0.5) / kSteps * 2 - 1;
            const double p = 2 * static_cast<double>(kPi * phase.density(static_cast<float>(c))) * 2 / kSteps;
            sum += p;
            cosine_sum += p * c;
            expected[static_cast<size_t>((c + 1) * 10)] += p;
        }
        CHECK(sum == Approx(1).epsilon(1e-4));
        CHECK(cosine_sum == Approx(static_cast<double>(g)).margin(1e-4));
        const Vec3 way = normalized(Vec3{0.3f, -0.5f, 0.7f});
        constexpr uint32_t kSamples = 40000;
        for (uint32_t k = 0; k < kSamples; ++k) {
            Sampler sampler(11, k, 0);
            const float c = dot(way, phase.sample(way, sampler.next_2d()));
            counts[std::min<size_t>(static_cast<size_t>((c + 1) * 10), 19)] += 1;
        }
        for (double& e : expected) e *= kSamples;
        INFO("g " << g);
        CHECK(testing::chi2_score(counts, expected) < kSigmas);
    }
}

}  // namespace lumi::baker
