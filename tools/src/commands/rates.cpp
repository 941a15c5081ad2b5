// SPDX-License-Identifier: MIT
#include "commands/rates.h"

#include <cstdio>

#include "../planner/chord_speed.h"
#include "../planner/speed.h"
#include "draw/draw_surface.h"

namespace lumi::tools
{

namespace
{

std::string part_text(const planner::PartRate& rate, bool has_worst)
{
    char text[80];
    const char* const form = has_worst ? "%s %.0f (%.0f)" : rate.mean < 1 ? "%s %.1g" : "%s %.0f";
    std::snprintf(text, sizeof text, form, rate.chip->title, rate.mean, rate.worst);
    return text;
}

}  // namespace

std::vector<ModeRates> rates_of(const FieldFile& file)
{
    std::vector<ModeRates> rates;
    if (file.is_surface())
        for (const SurfaceMode mode : {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two})
            rates.push_back({name_of(mode), planner::surface_rates(file.surface(), mode)});
    else
        for (const planner::ChordMode& mode : planner::chord_modes())
            rates.push_back({mode.name, planner::chord_rates(file.field(), mode.mode)});
    return rates;
}

std::string rates_text(const FieldFile& file)
{
    std::string text = "frames a second of 240 x 240 pixels, modelled, one core";
    if (file.is_surface())
        text += ", mean (worst) of " + std::to_string(planner::kRatedPoses) + " poses";
    else if (!planner::is_drawn_by_spans(file.field()))
        text += ", every pixel exact: spans refuse this field";
    text += ":\n";
    for (const ModeRates& mode : rates_of(file)) {
        char name[80];
        std::snprintf(name, sizeof name, "  %-12s", mode.mode);
        text += name;
        for (const planner::PartRate& rate : mode.parts)
            text += (text.back() == ' ' ? "" : ", ") + part_text(rate, file.is_surface());
        text += "\n";
    }
    return text;
}

}  // namespace lumi::tools
