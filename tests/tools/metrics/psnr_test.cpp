// SPDX-License-Identifier: MIT
#include "metrics/metrics.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/test_pictures.h"

namespace lumi::tools
{

TEST_CASE("PSNR of a constant difference has its closed form")
{
    for (const int difference : {1, 5, 100, 255}) {
        const Picture a(7, 3, {0, 0, 0});
        const auto d = static_cast<uint8_t>(difference);
        CHECK(psnr_db(a, Picture(7, 3, {d, d, d})) == Approx(20 * std::log10(255.0 / difference)));
    }
}

TEST_CASE("PSNR counts all three channels: an error in one is 10·log10(3) dB milder")
{
    const Picture a(4, 4, {50, 60, 70});
    CHECK(psnr_db(a, Picture(4, 4, {50, 70, 70})) == Approx(20 * std::log10(255.0 / 10) + 10 * std::log10(3.0)));
}

TEST_CASE("PSNR of identical pictures is infinite")
{
    const Picture a = test::random_picture(9, 5, 3);
    CHECK(std::isinf(psnr_db(a, a)));
}

TEST_CASE("PSNR of Gaussian noise is that of its variance")
{
    // Rounding to whole levels adds 1/12 to the variance; 3·128² samples leave the estimate within 0.1 dB.
    const Picture a(128, 128, {128, 128, 128});
    const double sigma = 4;
    CHECK(psnr_db(a, test::with_noise(a, sigma)) ==
          Approx(10 * std::log10(255 * 255 / (sigma * sigma + 1 / 12.0))).margin(0.1));
}

TEST_CASE("masked PSNR counts the mask's pixels alone")
{
    const Picture a(6, 4, {50, 60, 70});
    Picture b = a;
    Mask mask(6, 4);
    for (int y = 0; y < 4; ++y) {
        b.pixel(1, y)[0] = 60;
        b.pixel(4, y)[2] = 200;
        mask.at(1, y) = mask.at(2, y) = 1;
    }
    CHECK(psnr_db(a, b, mask) == Approx(20 * std::log10(255.0 / 10) + 10 * std::log10(6.0)));
}

}  // namespace lumi::tools
