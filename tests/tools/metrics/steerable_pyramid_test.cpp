// SPDX-License-Identifier: MIT
#include "metrics/steerable_pyramid.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "math/pi.h"

namespace lumi::tools
{

namespace
{

// cos of a wave with (u, v) periods over the plane.
Plane<double> wave(int width, int height, int u, int v, double amplitude)
{
    Plane<double> plane(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            plane.at(x, y) = amplitude * std::cos(2 * kPi * (u * x / double(width) + v * y / double(height)));
    return plane;
}

double largest(const Plane<Complex>& band)
{
    double modulus = 0;
    for (const Complex& value : band.values) modulus = std::max(modulus, std::abs(value));
    return modulus;
}

}  // namespace

TEST_CASE("the angular filters share every direction without loss")
{
    for (double angle = 0; angle < 2 * kPi; angle += 0.01) {
        const double fx = 0.1 * std::cos(angle), fy = 0.1 * std::sin(angle);
        double sum = 0;
        for (int k = 0; k < kOrientations; ++k) {
            const double forward = angular_factor(k, fx, fy), backward = angular_factor(k, -fx, -fy);
            sum += forward * forward + backward * backward;
            CHECK(forward * backward == 0);
        }
        REQUIRE(sum == Approx(1).epsilon(1e-9));
    }
}

TEST_CASE("the radial filters share every frequency between the lowest octave and half of Nyquist's without loss")
{
    constexpr int kLevels = 5;
    for (double frequency = std::ldexp(0.25, -kLevels + 1); frequency <= 0.25; frequency *= 1.01) {
        double sum = 0;
        for (int level = 0; level < kLevels; ++level) {
            const double factor = radial_factor(level, frequency, 0);
            sum += factor * factor;
        }
        REQUIRE(sum == Approx(1).epsilon(1e-9));
    }
    CHECK(radial_factor(0, 0, 0) == Approx(0).margin(1e-12));
    CHECK(radial_factor(0, 0.5, 0) == Approx(0).margin(1e-12));
}

TEST_CASE("a band holds a wave's amplitude as its modulus, at every size and decimation")
{
    // 1/8 cycle per pixel is the centre of level 1's octave; odd and oblong planes crop unevenly.
    const auto [width, height] = GENERATE(std::make_pair(64, 64), std::make_pair(72, 40), std::make_pair(104, 33));
    const SteerablePyramid pyramid(wave(width, height, width / 8, 0, 10));
    const Plane<Complex> band = pyramid.band(1, 0);
    CHECK(band.width_px == band_side(width, 1));
    const double expected = 10 * angular_factor(0, 0.125, 0);
    for (const Complex& value : band.values) REQUIRE(std::abs(value) == Approx(expected).epsilon(1e-9));
    CHECK(largest(pyramid.band(1, kOrientations / 2)) < 1e-9);  // the perpendicular orientation sees nothing
    CHECK(largest(pyramid.band(3, 0)) < 1e-9);                  // nor does an octave far away
}

TEST_CASE("a shift of the wave turns its coefficients' phase alike")
{
    const int width = 64, period = 8;
    Plane<double> shifted = wave(width, width, width / period, 0, 10);
    for (int y = 0; y < width; ++y)
        for (int x = 0; x < width; ++x) shifted.at(x, y) = 10 * std::cos(2 * kPi * (x - 1.0) / period);
    const Plane<Complex> a = SteerablePyramid(wave(width, width, width / period, 0, 10)).band(1, 0);
    const Plane<Complex> b = SteerablePyramid(shifted).band(1, 0);
    for (size_t i = 0; i < a.values.size(); ++i)
        REQUIRE(std::arg(a.values[i] * std::conj(b.values[i])) == Approx(2 * kPi / period).epsilon(1e-6));
}

TEST_CASE("a flat plane has empty bands")
{
    Plane<double> flat(48, 48);
    std::fill(flat.values.begin(), flat.values.end(), 200.0);
    for (int level = 0; level < 3; ++level) CHECK(largest(SteerablePyramid(flat).band(level, 3)) < 1e-9);
}

}  // namespace lumi::tools
