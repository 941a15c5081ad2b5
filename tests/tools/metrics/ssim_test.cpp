// SPDX-License-Identifier: MIT
#include "metrics/metrics.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "image/picture.h"
#include "support/test_pictures.h"

namespace lumi::tools
{

namespace
{

constexpr double kC1 = 6.5025, kC2 = 58.5225;  // (0.01·255)², (0.03·255)²

// One window by the definition: weighted moments around the weighted means, in two passes.
double brute_window(const Plane<double>& a, const Plane<double>& b, int left, int top)
{
    double total = 0, mean_a = 0, mean_b = 0, variances = 0, covariance = 0;
    const auto weight = [](int x, int y) {
        return std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / (2 * 1.5 * 1.5));
    };
    for (int y = 0; y < 11; ++y)
        for (int x = 0; x < 11; ++x) {
            total += weight(x, y);
            mean_a += weight(x, y) * a.at(left + x, top + y);
            mean_b += weight(x, y) * b.at(left + x, top + y);
        }
    mean_a /= total;
    mean_b /= total;
    for (int y = 0; y < 11; ++y)
        for (int x = 0; x < 11; ++x) {
            const double da = a.at(left + x, top + y) - mean_a, db = b.at(left + x, top + y) - mean_b;
            variances += weight(x, y) / total * (da * da + db * db);
            covariance += weight(x, y) / total * da * db;
        }
    return (2 * mean_a * mean_b + kC1) / (mean_a * mean_a + mean_b * mean_b + kC1) * (2 * covariance + kC2) /
           (variances + kC2);
}

double brute_ssim(const Picture& a, const Picture& b)
{
    const Plane<double> luma_a = luma_plane(a), luma_b = luma_plane(b);
    double sum = 0;
    for (int y = 0; y + 11 <= a.height_px; ++y)
        for (int x = 0; x + 11 <= a.width_px; ++x) sum += brute_window(luma_a, luma_b, x, y);
    return sum / ((a.width_px - 10) * (a.height_px - 10));
}

}  // namespace

TEST_CASE("SSIM of identical pictures is 1")
{
    const Picture a = test::random_picture(40, 20, 1);
    CHECK(ssim(a, a) == Approx(1).margin(1e-12));
}

TEST_CASE("SSIM of two flat pictures is the luminance term alone")
{
    const Picture a(20, 20, {100, 100, 100}), b(20, 20, {150, 150, 150});
    CHECK(ssim(a, b) == Approx((2 * 100 * 150 + kC1) / (100 * 100 + 150 * 150 + kC1)).epsilon(1e-9));
}

TEST_CASE("SSIM agrees with the definition computed window by window")
{
    // The separable filter and raw moments differ from centred ones by rounding alone.
    const Picture ball = test::ball_picture();
    CHECK(ssim(ball, test::with_noise(ball, 12)) == Approx(brute_ssim(ball, test::with_noise(ball, 12))).epsilon(1e-9));
    const Picture a = test::random_picture(37, 11, 5), b = test::random_picture(37, 11, 6);
    CHECK(ssim(a, b) == Approx(brute_ssim(a, b)).epsilon(1e-9));
}

TEST_CASE("SSIM is symmetric, falls with noise and turns negative for a negative")
{
    const Picture ball = test::ball_picture();
    const Picture mild = test::with_noise(ball, 5), strong = test::with_noise(ball, 20);
    CHECK(ssim(ball, mild) == Approx(ssim(mild, ball)).epsilon(1e-12));
    CHECK(ssim(ball, mild) < 0.99);
    CHECK(ssim(ball, strong) < ssim(ball, mild));
    Picture noise = test::random_picture(64, 64, 9), negative = noise;
    for (uint8_t& value : negative.rgb) value = static_cast<uint8_t>(255 - value);
    CHECK(ssim(noise, negative) < -0.9);
}

TEST_CASE("masked SSIM is the mean over the mask's windows")
{
    const Picture a = test::ball_picture();
    Picture b = a;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < b.width_px; ++x) b.pixel(x, y)[1] = static_cast<uint8_t>(b.pixel(x, y)[1] / 2);
    Mask upper(a.width_px, a.height_px), lower = upper, all = upper;
    for (int y = 0; y < a.height_px; ++y)
        for (int x = 0; x < a.width_px; ++x) {
            (y < 50 ? upper : lower).at(x, y) = 1;
            all.at(x, y) = 255;
        }
    CHECK(ssim(a, b, all) == Approx(ssim(a, b)).epsilon(1e-12));
    CHECK(ssim(a, b, lower) == Approx(1));
    CHECK(ssim(a, b, upper) < ssim(a, b));
    CHECK(ssim(a, b, Mask(a.width_px, a.height_px)) == 1);
}

}  // namespace lumi::tools
