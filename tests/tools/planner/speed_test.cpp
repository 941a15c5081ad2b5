// SPDX-License-Identifier: MIT
// Which modes a part can draw at a pace.
#include "planner/speed.h"

#include <catch2/catch.hpp>

namespace lumi::planner
{

namespace
{

size_t modes_at(const std::string& pace)
{
    return affordable_modes(parse_pace(pace)).size();
}

}  // namespace

TEST_CASE("a pace is a part and a rate")
{
    const auto pace = parse_pace("rp2040@12.5fps");
    REQUIRE(pace);
    CHECK(std::string(pace->chip->title) == "RP2040");
    CHECK(pace->frames_per_second == 12.5);
    for (const char* text : {"", "rp2040", "rp2040@", "rp2040@30", "rp2040@fps", "@30fps", "z80@30fps", "rp2040@0fps",
                             "rp2040@-1fps", "rp2040@nanfps", "rp2040@30fpsx", "rp2040@3 fps", "rp2040@infs"})
        CHECK_FALSE(parse_pace(text));
}

TEST_CASE("without a pace a plan is drawn in the mode of lumi render")
{
    CHECK(std::string(affordable_modes({}).at(0).name) == "linear");
    CHECK(affordable_modes({}).size() == 1);
}

TEST_CASE("a faster pace leaves fewer modes, and in the end none")
{
    CHECK(modes_at("stm32h7@1fps") == chord_modes().size());
    size_t before = chord_modes().size();
    for (const char* pace : {"rp2040@1fps", "rp2040@5fps", "rp2040@10fps", "rp2040@20fps", "rp2040@60fps"}) {
        CHECK(modes_at(pace) <= before);
        before = modes_at(pace);
    }
    CHECK(modes_at("stm32h7@100fps") == 0);  // the display ends at 67.8
}

TEST_CASE("modes are listed dearest first")
{
    for (const char* core : {"m0plus", "m4"}) {
        double before = 1e18;
        for (const DrawMode& mode : chord_modes()) {
            const double cost = frame_cost(core, mode).instructions;
            INFO(core << " " << mode.name);
            CHECK(cost < before);
            before = cost;
        }
    }
}

}  // namespace lumi::planner
