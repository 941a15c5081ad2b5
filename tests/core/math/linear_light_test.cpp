// SPDX-License-Identifier: MIT
#include "lumi/linear_light.h"

#include <catch2/catch.hpp>

#include "report.h"
#include "srgb.h"

using namespace lumi;
using namespace lumi::test;

TEST_CASE("encoded levels and light are each other's inverse, and mixtures are the nearest level", "[guided]")
{
    for (uint32_t level = 0; level < 256; ++level) CHECK(encoded_level(kLinearLight.at[level]) == level);
    CHECK(encoded_level(65535) == 255);
    Worst worst;
    for (uint32_t a = 0; a < 256; ++a) {
        for (uint32_t b = 0; b < 256; b += 5) {
            LightMixture mixture;
            const auto grey = [](uint32_t v) {
                return Rgb8{static_cast<uint8_t>(v), 0, static_cast<uint8_t>(255 - v)};
            };
            mixture.add(grey(a), 1);
            mixture.add(grey(b), 3);
            const double mean = (light_of_level(a) + 3 * light_of_level(b)) / 4;
            const double level = level_of_light(mean);
            worst.see(std::fabs(mixture.colour().r - level), a * 256 + b);
        }
    }
    worst.report("mixture of two levels");
    CHECK(worst.error < 0.56);  // half a level; nearest in light is not quite nearest in level
}
