// SPDX-License-Identifier: MIT
// Which modes a part can draw at a pace.
#include "planner/speed.h"

#include <catch2/catch.hpp>

namespace lumi::planner
{

namespace
{

constexpr FrameShare kShare = {42000, 20000};

Plan plan_with(Layout layout)
{
    Plan plan;
    plan.layout = layout;
    return plan;
}

size_t modes_at(const std::string& pace, Layout layout)
{
    return affordable_modes(parse_pace(pace), plan_with(layout), kShare).size();
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
    CHECK(std::string(affordable_modes({}, plan_with(Layout::guided), kShare).at(0).name) == "linear, antialiased");
    CHECK(affordable_modes({}, plan_with(Layout::guided), kShare).size() == 1);
    CHECK(std::string(affordable_modes({}, plan_with(Layout::chord), kShare).at(0).name) == "linear");
}

TEST_CASE("a faster pace leaves fewer modes, and in the end none")
{
    for (const Layout layout : {Layout::guided, Layout::focus, Layout::chord}) {
        CHECK(modes_at("stm32h7@1fps", layout) == modes_of(layout).size());
        size_t before = modes_of(layout).size();
        for (const char* pace : {"rp2040@1fps", "rp2040@5fps", "rp2040@10fps", "rp2040@20fps", "rp2040@60fps"}) {
            CHECK(modes_at(pace, layout) <= before);
            before = modes_at(pace, layout);
        }
        CHECK(modes_at("stm32h7@100fps", layout) == 0);  // the display ends at 67.8
    }
}

TEST_CASE("modes are listed dearest first, and more triangles and more pixels cost more")
{
    for (const char* core : {"m0plus", "m4"})
        for (const Layout layout : {Layout::guided, Layout::focus, Layout::chord}) {
            double before = 1e18;
            for (const DrawMode& mode : modes_of(layout)) {
                const double cost = frame_cost(core, plan_with(layout), mode, kShare).instructions;
                INFO(core << " " << name_of(layout) << " " << mode.name);
                CHECK(cost < before);
                before = cost;
            }
        }
    Plan plan = plan_with(Layout::guided);
    const DrawMode& best = modes_of(Layout::guided)[0];
    const double cost = frame_cost("m4", plan, best, kShare).instructions;
    CHECK(frame_cost("m4", plan, best, {42000, 30000}).instructions > cost);
    plan.guided.proxy_triangles *= 2;
    CHECK(frame_cost("m4", plan, best, kShare).instructions > cost);
}

}  // namespace lumi::planner
