// SPDX-License-Identifier: MIT
#include "fit/encoded_tone.h"

#include <catch2/catch.hpp>

namespace lumi::baker::testing
{
namespace
{

constexpr ToneCurve kCurves[] = {ToneCurve::srgb, ToneCurve::reinhard, ToneCurve::aces, ToneCurve::agx};
const LevelColour kColours[] = {{0, 0, 0}, {2, 30, 90}, {128, 128, 128}, {200, 40, 7}, {250, 251, 252}};

float largest_difference(const LevelColour& a, const LevelColour& b)
{
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

}  // namespace

TEST_CASE("a tone's line touches the tone where it was asked for")
{
    for (const ToneCurve curve : kCurves) {
        const EncodedTone tone(curve);
        for (const LevelColour& c : kColours) {
            const ToneLine line = tone.line_at(c);
            CHECK(largest_difference(line.levels, c) < 0.2f);  // steps of a quarter, and curves that end below 255
            CHECK(largest_difference(tone.encoded(line.at), line.levels) < 0.02f);
            const Rgb near = line.at * 1.01f + grey(1e-5f);
            CHECK(largest_difference(tone.encoded(near), line(near)) < 0.02f);
        }
    }
}

TEST_CASE("a tone's line lies above the tone, so the mean of noisy light is not darkened")
{
    const EncodedTone tone(ToneCurve::srgb);
    const ToneLine line = tone.line_at({60, 60, 60});
    for (const float light : {0.0f, 0.01f, 0.2f, 1.0f, 30.0f})
        CHECK(line(grey(light))[0] >= tone.encoded(grey(light))[0] - 0.01f);
    const LevelColour mean = line((grey(0) + grey(0.2f)) * 0.5f);
    CHECK((line(grey(0))[0] + line(grey(0.2f))[0]) / 2 == Approx(mean[0]).margin(0.01));
}

TEST_CASE("a tone's line can be inverted")
{
    for (const ToneCurve curve : kCurves) {
        const ToneLine line = EncodedTone(curve).line_at({90, 60, 30});
        const Rgb light = {0.3f, 0.02f, 0.1f};
        const Rgb back = line.inverse(line(light));
        CHECK(back.r == Approx(light.r).margin(1e-4));
        CHECK(back.g == Approx(light.g).margin(1e-4));
        CHECK(back.b == Approx(light.b).margin(1e-4));
    }
}

TEST_CASE("a line that is to be inverted is steep enough near white, and a tangent elsewhere")
{
    for (const ToneCurve curve : kCurves) {
        const EncodedTone tone(curve);
        for (const float level : {1.0f, 60.0f, 150.0f, 230.0f, 252.0f, 255.0f}) {
            const ToneLine line = tone.invertible_line_at({level, level, level});
            CHECK(largest_difference(line.levels, tone.line_at({level, level, level}).levels) == 0);
            const LevelColour darker = line(line.at * 0.9f);
            CHECK(line.levels[1] - darker[1] > 0.024f * line.levels[1]);
        }
        CHECK(tone.invertible_line_at({90, 60, 30}).slope == tone.line_at({90, 60, 30}).slope);
    }
}

}  // namespace lumi::baker::testing
