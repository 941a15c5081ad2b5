// SPDX-License-Identifier: MIT
// The modes of chord fields, parts and paces for which rates are asked. chord_speed.h tells the rates.
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

// A part and a pace, as --for asks for them.
struct Pace {
    const Chip* chip;
    double frames_per_second;
};
// The pace of a part without a rate: an object that people turn moves, and does not jump.
inline constexpr double kUsualPace = 10;

// "rp2040@30fps", "rp2040"; nothing for other texts, unknown parts and rates that are not above 0.
std::optional<Pace> parse_pace(const std::string& text);
// "rp2040, rp2350, … or esp32c3".
std::string chip_names();

}  // namespace lumi::planner
