// SPDX-License-Identifier: MIT
#include "math/warp.h"

#include <catch2/catch.hpp>

namespace lumi::baker
{

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
