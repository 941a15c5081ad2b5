// SPDX-License-Identifier: MIT
// How fast a part draws a field in each mode: a model, of counted instructions, that decides which modes a plan may
// count on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/chips.h"
#include "draw/draw.h"
#include "draw/draw_guided.h"
#include "planner/plan.h"

namespace lumi::planner
{

// A way to draw a layout. Of the two modes, one is the layout's own.
struct DrawMode {
    const char* name;
    tools::GuidedMode guided;
    bool antialiased;
    tools::Mode chord;
};

// Dearest and best first.
const std::vector<DrawMode>& modes_of(Layout layout);

// What --for asks for.
struct Pace {
    const bench::Chip* chip;
    double frames_per_second;
};

// "rp2040@30fps"; nothing for other texts, unknown parts and rates that are not above 0.
std::optional<Pace> parse_pace(const std::string& text);
// "rp2040, rp2350, stm32f4, stm32h7 or esp32s3".
std::string chip_names();

// What of a frame of 240 × 240 pixels the scene covers, on average over the views.
struct FrameShare {
    double sphere_px = 0, object_px = 0;
};

struct FrameCost {
    double instructions = 0;
    double misses = 0;  // of flash lines
};
// What a frame takes with the code of `core` ("m0plus", else M4 code); figures and their sources: docs/log/quality.md.
FrameCost frame_cost(const std::string& core, const Plan& plan, const DrawMode& mode, const FrameShare& share);

// Frames per second by the model of `lumi bench`.
double modelled_rate(const bench::Chip& chip, const Plan& plan, const DrawMode& mode, const FrameShare& share);

// The modes that a part draws at that pace, best first; without a pace the best alone.
std::vector<DrawMode> affordable_modes(const std::optional<Pace>& pace, const Plan& plan, const FrameShare& share);

}  // namespace lumi::planner
