// SPDX-License-Identifier: MIT
// How instructions become rates, and what a pace is.
#include "planner/speed.h"

#include <catch2/catch.hpp>
#include <set>

namespace lumi::planner
{

TEST_CASE("the slower of drawing and sending limits the frame rate")
{
    const Chip chip = {"x", "X", "m4", 100, 2.0, {64, 2, 8}, 500, ""};
    CHECK(frames_per_second(chip, 0, 0) == Approx(67.8).epsilon(0.001));
    CHECK(frames_per_second(chip, 5'000'000, 0) == Approx(10));       // 10 M clocks at 100 MHz
    CHECK(frames_per_second(chip, 5'000'000, 200'000) == Approx(5));  // and as long again in flash
}

TEST_CASE("a pace is a part, with or without a rate")
{
    const auto pace = parse_pace("rp2040@12.5fps");
    REQUIRE(pace);
    CHECK(std::string(pace->chip->title) == "RP2040");
    CHECK(pace->frames_per_second == 12.5);
    CHECK((pace->is_asked && pace->cores == 1));
    CHECK(parse_pace("esp32s3")->frames_per_second == kUsualPace);
    CHECK_FALSE(parse_pace("esp32s3")->is_asked);
    CHECK(parse_pace("rp2350x2@9fps")->cores == 2);
    CHECK_FALSE(parse_pace("stm32f4x2@9fps"));  // has one
    for (const char* text : {"", "rp2040@", "rp2040@30", "rp2040@fps", "@30fps", "z80@30fps", "rp2040@0fps",
                             "rp2040@-1fps", "rp2040@nanfps", "rp2040@30fpsx", "rp2040@3 fps", "rp2040@infs"})
        CHECK_FALSE(parse_pace(text));
}

TEST_CASE("each part has a name of its own, a clock, RAM and a cache that lines fill")
{
    std::set<std::string> keys;
    for (const Chip& chip : kChipList) {
        INFO(chip.title);
        keys.insert(chip.key);
        CHECK(parse_pace(chip.key)->chip == &chip);
        CHECK(chip.clock_mhz >= 64);
        CHECK(chip.ram_bytes >= 128 * 1024);
        CHECK(chip.miss_ns > 0);
        CHECK(chip.cache.sets() * chip.cache.ways * chip.cache.line_bytes == chip.cache.bytes);
    }
    CHECK(keys.size() == kChips);
}

TEST_CASE("parts of another instruction set than the one that was counted bear a star")
{
    for (const Chip& chip : kChipList) {
        const bool is_arm = std::string(chip.title).find("ESP32") == std::string::npos;
        CHECK(marked_title(chip) == std::string(chip.title) + (is_arm ? "" : "*"));
    }
}

}  // namespace lumi::planner
