// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <random>

#include "lumi/surface/detail/packed_colour.h"

using namespace lumi;
using namespace lumi::detail;

namespace
{

PackedColour grey(uint32_t level)
{
    return packed_colour(4 * level + 2, 4 * level + 2, 4 * level + 2);
}

constexpr PackedColour kBlack = packed_colour(2, 2, 2);

double root_mean_square(const uint32_t (&level)[4])
{
    double sum = 0;
    for (const uint32_t v : level) sum += v * v;
    return std::sqrt(sum / 4);
}

}  // namespace

TEST_CASE("samples that differ much are averaged as light, each channel to the nearest level")
{
    std::minstd_rand random(3);
    for (int k = 0; k < 20000; ++k) {
        const uint32_t level[4] = {random() % 128, random() % 256, random() % 256, 192 + random() % 64};
        const Rgb8 mean = unpacked(mean_of(grey(level[0]), grey(level[1]), grey(level[2]), grey(level[3]), kBlack));
        CAPTURE(level[0], level[1], level[2], level[3]);
        REQUIRE(std::fabs(mean.r - root_mean_square(level)) < 1.01);
        REQUIRE(((mean.r == mean.g) && (mean.g == mean.b)));
    }
    const Rgb8 half = unpacked(mean_of(packed_colour(1022, 2, 2), packed_colour(2, 1022, 2), packed_colour(1022, 2, 2),
                                       packed_colour(2, 1022, 2), kBlack));
    CHECK((half == Rgb8{180, 180, 0}));
    CHECK((unpacked(mean_of(grey(0), grey(0), grey(0), grey(255), kBlack)) == Rgb8{127, 127, 127}));
}

TEST_CASE("samples that are alike have the mean of their levels, and a colour is the mean of itself")
{
    for (uint32_t v = 0; v < 256; ++v) {
        const uint8_t level = static_cast<uint8_t>(v);
        CHECK((unpacked(mean_of(grey(v), grey(v), grey(v), grey(v), kBlack)) == Rgb8{level, level, level}));
    }
    for (uint32_t v = 0; v < 256; ++v) {
        for (uint32_t other = v < 32 ? 0 : v - 32; other < std::min(v + 32, 256u); ++other) {
            const Rgb8 mean = unpacked(mean_of(grey(v), grey(v), grey(other), grey(v), kBlack));
            REQUIRE(std::abs(4 * mean.g - static_cast<int>(3 * v + other)) <= 4);
        }
    }
}

TEST_CASE("any channel and any sample that differs much makes samples averaged as light")
{
    for (uint32_t channel = 0; channel < 3; ++channel) {
        for (uint32_t sample = 0; sample < 4; ++sample) {
            PackedColour c[4];
            for (uint32_t k = 0; k < 4; ++k) {
                const uint32_t level = k == sample ? 4 * 130 + 2 : 2;
                c[k] = packed_colour(channel == 0 ? level : 2, channel == 1 ? level : 2, channel == 2 ? level : 2);
            }
            const Rgb8 mean = unpacked(mean_of(c[0], c[1], c[2], c[3], kBlack));
            CHECK(mean.r + mean.g + mean.b == 65);
        }
    }
}
