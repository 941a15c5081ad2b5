// SPDX-License-Identifier: MIT
// How fast named parts draw a field in each of its modes, by the planner's models.
#pragma once

#include <string>
#include <vector>

#include "../planner/surface_speed.h"
#include "files/field_file.h"

namespace lumi::tools
{

struct ModeRates {
    const char* mode;
    std::vector<planner::PartRate> parts;  // chord fields: the mean alone, of a view that the sphere fills
};

// Surface fields: from the fastest mode to the finest; chord fields: from the best to the fastest.
std::vector<ModeRates> rates_of(const FieldFile& file);

// For people; ends with a line break.
std::string rates_text(const FieldFile& file);

}  // namespace lumi::tools
