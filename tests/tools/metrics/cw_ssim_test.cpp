// SPDX-License-Identifier: MIT
#include "metrics/metrics.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "support/test_pictures.h"

namespace lumi::tools
{

namespace
{

// 128 plus or minus 18 for each of six octaves of random blocks, 1 to 32 pixels wide.
Picture block_noise()
{
    std::mt19937 random(7);
    Picture picture(96, 96, {128, 128, 128});
    for (int block = 1; block <= 32; block *= 2)
        for (int top = 0; top < 96; top += block)
            for (int left = 0; left < 96; left += block) {
                const int step = random() % 2 != 0 ? 18 : -18;
                for (int y = top; y < top + block; ++y)
                    for (int x = left; x < left + block; ++x)
                        for (int channel = 0; channel < 3; ++channel)
                            picture.pixel(x, y)[channel] = static_cast<uint8_t>(picture.pixel(x, y)[channel] + step);
            }
    return picture;
}

}  // namespace

TEST_CASE("CW-SSIM of identical pictures is 1")
{
    const Picture a = test::random_picture(40, 23, 1);
    CHECK(cw_ssim(a, a) == Approx(1).margin(1e-12));
    const Picture flat(16, 16, {9, 9, 9});
    CHECK(cw_ssim(flat, flat) == Approx(1).margin(1e-12));
}

TEST_CASE("CW-SSIM does not see a change of brightness")
{
    CHECK(cw_ssim(test::ball_picture(), test::ball_picture(0, 0, 1, 15)) > 0.9999);
}

TEST_CASE("CW-SSIM of a change of contrast has its closed form where K is negligible")
{
    // For a gain g it is 2g/(1+g²). Noise in blocks of every size has energy of hundreds of squared grey levels in
    // every band; K = 1 adds a few thousandths where they are fewest.
    const Picture a = block_noise();
    Picture b = a;
    for (uint8_t& value : b.rgb)
        value = static_cast<uint8_t>(128 + (value - 128) / 2);  // exact: block_noise() is even around 128
    CHECK(cw_ssim(a, b) == Approx(0.8).margin(0.008));
}

TEST_CASE("CW-SSIM hardly falls with small shifts and turns, but ten times as far with noise and blur")
{
    const Picture ball = test::ball_picture();
    const auto loss = [&](const Picture& other) { return 1 - cw_ssim(ball, other); };
    const double shift = loss(test::ball_picture(1)), turn = loss(test::ball_picture(0, 0.02));
    const double noise = loss(test::with_noise(ball, 10)), blur = loss(test::blurred(ball, 3));
    INFO("loss by shift " << shift << ", turn " << turn << ", noise " << noise << ", blur " << blur);
    CHECK(shift < 0.01);
    CHECK(turn < 0.01);
    CHECK(noise > 10 * std::max(shift, turn));
    CHECK(blur > 10 * std::max(shift, turn));
}

TEST_CASE("CW-SSIM is symmetric and falls as noise grows")
{
    const Picture ball = test::ball_picture();
    double last = 1;
    for (const double sigma : {2.0, 5.0, 10.0, 20.0, 40.0}) {
        const Picture noisy = test::with_noise(ball, sigma);
        CHECK(cw_ssim(ball, noisy) == Approx(cw_ssim(noisy, ball)).epsilon(1e-12));
        CHECK(cw_ssim(ball, noisy) < last);
        last = cw_ssim(ball, noisy);
    }
    CHECK(last < 0.8);
}

TEST_CASE("CW-SSIM takes pictures of any shape down to one window")
{
    for (const auto& [width, height] : {std::make_pair(7, 7), std::make_pair(11, 200), std::make_pair(131, 17)}) {
        const double likeness = cw_ssim(test::random_picture(width, height, 1), test::random_picture(width, height, 2));
        CHECK(likeness > 0);
        CHECK(likeness < 0.9);
    }
}

}  // namespace lumi::tools
