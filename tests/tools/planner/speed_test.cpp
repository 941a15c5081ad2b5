// SPDX-License-Identifier: MIT
// How instructions become rates, and what a pace is.
#include "planner/speed.h"

#include <catch2/catch.hpp>

namespace lumi::planner
{

TEST_CASE("the slower of drawing and sending limits the frame rate")
{
    const Chip chip = {"x", "X", "m4", 100, 2.0, {64, 2, 8}, 500, ""};
    CHECK(frames_per_second(chip, 0, 0) == Approx(67.8).epsilon(0.001));
    CHECK(frames_per_second(chip, 5'000'000, 0) == Approx(10));       // 10 M clocks at 100 MHz
    CHECK(frames_per_second(chip, 5'000'000, 200'000) == Approx(5));  // and as long again in flash
}

TEST_CASE("two cores share what comes after the preparing, and wait for flash as long as one")
{
    const Chip chip = {"x", "X", "m4", 100, 2.0, {64, 2, 8}, 500, "", 2};
    CHECK(frames_per_second_of_two(chip, 0, 10'000'000, 0) == Approx(10));
    CHECK(frames_per_second_of_two(chip, 5'000'000, 10'000'000, 0) == Approx(5));
    CHECK(frames_per_second_of_two(chip, 0, 10'000'000, 200'000) == Approx(5));
}

TEST_CASE("a pace is a part, with or without a rate")
{
    const auto pace = parse_pace("rp2040@12.5fps");
    REQUIRE(pace);
    CHECK(std::string(pace->chip->title) == "RP2040");
    CHECK(pace->frames_per_second == 12.5);
    CHECK(parse_pace("esp32s3")->frames_per_second == kUsualPace);
    for (const char* text : {"", "rp2040@", "rp2040@30", "rp2040@fps", "@30fps", "z80@30fps", "rp2040@0fps",
                             "rp2040@-1fps", "rp2040@nanfps", "rp2040@30fpsx", "rp2040@3 fps", "rp2040@infs"})
        CHECK_FALSE(parse_pace(text));
}

}  // namespace lumi::planner
