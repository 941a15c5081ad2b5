// SPDX-License-Identifier: MIT
// How fast a part draws a chord field in each mode: a model, of counted instructions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/draw.h"
#include "planner/chips.h"

namespace lumi::planner
{

// A way to draw a chord field.
struct ChordMode {
    const char* name;
    tools::Mode mode;
};

// Dearest and best first.
const std::vector<ChordMode>& chord_modes();

// What --for asks for.
struct Pace {
    const Chip* chip;
    double frames_per_second;
};

// "rp2040@30fps"; nothing for other texts, unknown parts and rates that are not above 0.
std::optional<Pace> parse_pace(const std::string& text);
// "rp2040, rp2350, stm32f4, stm32h7 or esp32s3".
std::string chip_names();

struct FrameCost {
    double instructions = 0;
    double misses = 0;  // flash lines that the cache misses
};
// What a frame of 240 × 240 pixels that the sphere fills takes with the code of `core` ("m0plus", else M4 code);
// figures and their sources: docs/log/tradeoff.md.
FrameCost frame_cost(const std::string& core, const ChordMode& mode);

// Frames per second by the model of chips.h.
double modelled_rate(const Chip& chip, const ChordMode& mode);

}  // namespace lumi::planner
