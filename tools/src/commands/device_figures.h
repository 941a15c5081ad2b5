// SPDX-License-Identifier: MIT
// The needs of a field on devices: RAM, stack, flash, and how fast named parts draw it by the planner's models.
#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../planner/speed.h"
#include "files/field_file.h"

namespace lumi::tools
{

// Returns printf's text, at most 255 characters of it.
template <class... Values>
std::string formatted(const char* pattern, Values... values)
{
    char text[256];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

// A screen, and the parts that drive it.
struct Device {
    host::ScreenSize screen;
    std::vector<const planner::Chip*> parts;  // empty: all that have a model
};

struct ModeFigures {
    const char* mode;
    planner::Ram ram;
    std::vector<planner::PartRate> parts;  // chord fields: the mean alone, of a view that the sphere fills
};

// Modes of surface fields go from the fastest to the finest, those of chord fields from the best to the fastest.
std::vector<ModeFigures> device_figures(const FieldFile& file, const Device& device = {});

// For people; ends with a line break.
std::string device_text(const FieldFile& file, const Device& device = {});

// The finest mode that the part draws at that pace, else its fastest one, how fast that is, and its RAM: a line.
std::string pace_text(const FieldFile& file, const planner::Pace& pace, const host::ScreenSize& screen = {});

// "screen", "stack_bytes", "chips", and by mode "ram_bytes", "frames_per_second", "worst_frames_per_second".
nlohmann::ordered_json device_json(const FieldFile& file, const Device& device = {});

}  // namespace lumi::tools
