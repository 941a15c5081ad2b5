// SPDX-License-Identifier: MIT
#include "lumi/detail/math.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "report.h"
#include "twin.h"

using namespace lumi;
using namespace lumi::detail;
using twin::kPi;

namespace
{

template <class Random>
double uniform(Random& random)
{
    return std::generate_canonical<double, 32>(random);
}

}  // namespace

TEST_CASE("sin and cos stay within 2^-28 over the whole turn", "[math]")
{
    Worst worst;
    std::minstd_rand random(1);
    for (uint32_t k = 0; k < kSweep; ++k) {
        const uint32_t angle = k < 4096 ? k << 20 : static_cast<uint32_t>(uniform(random) * 4294967296.0);
        const SinCos value = sin_cos(angle);
        const double radians = 2 * kPi * angle / 4294967296.0;
        worst.see(std::fabs(twin::from_q30(value.sin_q30) - std::sin(radians)), angle);
        worst.see(std::fabs(twin::from_q30(value.cos_q30) - std::cos(radians)), angle);
    }
    worst.report("sin_cos, absolute error");
    CHECK(worst.error < std::ldexp(1.0, -28));
}

TEST_CASE("the angle of a vector stays within 2^-27 turn, axes and diagonals included", "[math]")
{
    Worst worst;
    std::minstd_rand random(2);
    for (uint32_t k = 0; k < kSweep; ++k) {
        const double turns = k < 4096 ? k / 4096.0 : uniform(random);
        const double radius = std::ldexp(1.0, -static_cast<int>(k % 9));
        const int32_t x = twin::to_q30(radius * std::cos(2 * kPi * turns));
        const int32_t y = twin::to_q30(radius * std::sin(2 * kPi * turns));
        const double truth = std::atan2(static_cast<double>(y), static_cast<double>(x)) / (2 * kPi);
        const double error = angle_turns32(y, x) / 4294967296.0 - truth;
        worst.see(std::fabs(error - std::round(error)), k);
    }
    worst.report("angle_turns32, turns");
    CHECK(worst.error < std::ldexp(1.0, -27));
    CHECK(angle_turns32(0, 0) == 0);
    CHECK(angle_turns32(kOneQ30, 0) == 0x40000000u);
    CHECK(angle_turns32(0, -kOneQ30) == 0x80000000u);
    CHECK(angle_turns32(-kOneQ30, 0) == 0xC0000000u);
}

TEST_CASE("square roots and reciprocal roots stay within 2^-28 from 1 to 2^64", "[math]")
{
    Worst worst_root;
    Worst worst_reciprocal;
    std::mt19937_64 random(3);
    for (uint32_t k = 0; k < kSweep; ++k) {
        const uint64_t v = (random() >> (k % 64)) | 1u;
        const double truth = std::sqrt(static_cast<double>(v));
        const ReciprocalRoot r = reciprocal_root(v);
        worst_reciprocal.see(std::fabs(std::ldexp(static_cast<double>(r.mantissa), -r.exponent) * truth - 1), k);
        worst_root.see(std::fmax(0.0, std::fabs(square_root(v) - truth) - 1) / truth, k);
    }
    worst_reciprocal.report("reciprocal_root, relative error");
    worst_root.report("square_root, relative error beyond one unit");
    CHECK(worst_reciprocal.error < std::ldexp(1.0, -28));
    CHECK(worst_root.error < std::ldexp(1.0, -28));
    CHECK(square_root(0) == 0);
    CHECK(square_root(UINT64_MAX) >= 0xFFFFFFF0u);
}

TEST_CASE("multiply_shift keeps the high bits of a 96-bit product", "[math]")
{
    CHECK(multiply_shift(int64_t{1} << 50, kOneQ30, 30) == int64_t{1} << 50);
    CHECK(multiply_shift(-(int64_t{1} << 50), kOneQ30, 30) == -(int64_t{1} << 50));
    CHECK(multiply_shift((int64_t{1} << 46) + 12345, 3 << 20, 20) == 3 * ((int64_t{1} << 46) + 12345));
    CHECK(multiply_shift(-5, 1 << 10, 11) == -3);  // rounds down
}
