// SPDX-License-Identifier: MIT
#include "metrics/metrics.h"

#include <catch2/catch.hpp>

#include "support/test_pictures.h"

namespace lumi::tools
{

namespace
{

Picture flat(const lumi::Rgb8& colour)
{
    return {48, 40, colour};
}

}  // namespace

TEST_CASE("FLIP of a picture with itself is zero")
{
    const Picture picture = test::ball_picture();
    CHECK(flip(picture, picture) == Approx(0).margin(1e-12));
}

TEST_CASE("FLIP of the most different colours, green and blue, is one")
{
    CHECK(flip(flat({0, 255, 0}), flat({0, 0, 255})) == Approx(1).margin(1e-6));
}

// HyAB is 100 and green against blue 203.0 with the Hunt effect: (100/203.0)^0.7 = 0.609, above the knee at 0.4.
TEST_CASE("FLIP of black and white is what the paper's formulas give by hand")
{
    CHECK(flip(flat({0, 0, 0}), flat({255, 255, 255})) == Approx(0.95 + 0.05 * (0.609 - 0.4) / 0.6).margin(5e-4));
}

TEST_CASE("FLIP is symmetric and grows with the difference")
{
    const Picture grey = flat({100, 100, 100}), near = flat({104, 100, 100}), far = flat({140, 100, 100});
    CHECK(flip(grey, near) == Approx(flip(near, grey)));
    CHECK(flip(grey, near) > 0);
    CHECK(flip(grey, far) > 2 * flip(grey, near));
}

TEST_CASE("FLIP sees a line that its colour filters alone would blur away")
{
    const Picture grey = flat({128, 128, 128});
    Picture line = grey;
    for (int y = 0; y < line.height_px; ++y) line.pixel(20, y)[0] = line.pixel(20, y)[1] = line.pixel(20, y)[2] = 255;
    const Plane<double> map = flip_map(grey, line);
    CHECK(map.at(20, 20) > 0.3);
    CHECK(map.at(2, 20) == Approx(0).margin(1e-6));
    CHECK(map.at(20, 20) == Approx(map.at(20, 5)).margin(0.05));
}

TEST_CASE("FLIP forgives a fine pattern more from farther away")
{
    Picture checker = flat({110, 110, 110});
    for (int y = 0; y < checker.height_px; ++y)
        for (int x = 0; x < checker.width_px; ++x)
            if ((x + y) % 2 != 0) std::fill_n(checker.pixel(x, y), 3, uint8_t{142});
    const Picture grey = flat({127, 127, 127});
    CHECK(flip(grey, checker, 67) < 0.5 * flip(grey, checker, 10));
}

}  // namespace lumi::tools
