// SPDX-License-Identifier: MIT
#include "planner/space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "lumi/texel.h"

namespace lumi::planner
{

namespace
{

constexpr std::array<uint32_t, 6> kCapPercent = {50, 60, 70, 80, 90, 100};
constexpr size_t kStartCap = 4;  // a level eye at 2.5 radii looks through the upper 85 % of the origins' heights
constexpr std::array<double, 5> kShapes = {0.25, 0.5, 1, 2, 4};  // N/M
constexpr size_t kStartShape = 2;
constexpr std::array<format::TexelFormat, 4> kTexels = {format::TexelFormat::palette8, format::TexelFormat::rgb565,
                                                        format::TexelFormat::rgb888, format::TexelFormat::luma8};

// The coordinates by their names, which are also what people read.
constexpr const char kShapeName[] = "directions per origin", kTexelName[] = "texel", kCapName[] = "cap";

Coordinate cap_coordinate(const Task& task)
{
    if (task.by_hand.cap || task.views == quality::ViewSet::all) return {kCapName, {"100"}, 0, true};
    Coordinate cap = {kCapName, {}, kStartCap, true};
    for (const uint32_t percent : kCapPercent) cap.choices.push_back(std::to_string(percent));
    return cap;
}

Coordinate shape_coordinate(const ByHand& set)
{
    if (set.origins || set.directions) return {kShapeName, {"1"}, 0, true};
    Coordinate shape = {kShapeName, {}, kStartShape, true};
    for (const double share : kShapes)
        shape.choices.push_back(share < 1 ? "1/" + std::to_string(std::lround(1 / share))
                                          : std::to_string(std::lround(share)));
    return shape;
}

Coordinate texel_coordinate(const ByHand& set)
{
    if (set.texel) return {kTexelName, {texel_name(*set.texel)}, 0, false};
    return {kTexelName, {"palette8", "rgb565"}, 0, false};
}

size_t place_of(const Family& family, const Candidate& candidate, const char* name)
{
    for (size_t c = 0; c < family.coordinates.size(); ++c)
        if (family.coordinates[c].name == name) return candidate.choice[c];
    throw std::logic_error(std::string("a family without ") + name);
}

const std::string& word_of(const Family& family, const Candidate& candidate, const char* name)
{
    const auto coordinate = std::find_if(family.coordinates.begin(), family.coordinates.end(),
                                         [&](const Coordinate& c) { return c.name == name; });
    return coordinate->choices[place_of(family, candidate, name)];
}

uint32_t used_of(const Task& task, const std::string& percent, uint32_t origins)
{
    constexpr uint32_t kHundred = 100;
    if (task.by_hand.cap) return task.by_hand.cap(origins);
    return (origins * static_cast<uint32_t>(std::stoul(percent)) + kHundred - 1) / kHundred;
}

}  // namespace

std::vector<Family> families_of(const Task& task)
{
    return {{"chord", {shape_coordinate(task.by_hand), texel_coordinate(task.by_hand), cap_coordinate(task)}}};
}

Plan plan_of(const Task& task, const std::vector<Family>& families, const Candidate& candidate)
{
    constexpr uint32_t kUnsized = 1000;  // origins; fit_plan() scales both
    const Family& family = families[candidate.family];
    const ByHand& set = task.by_hand;
    const double ratio = set.origins || set.directions ? 1 : kShapes[place_of(family, candidate, kShapeName)];
    Plan plan;
    baker::BakeSettings& s = plan.chord;
    s.origins = set.origins.value_or(kUnsized);
    s.directions = set.directions.value_or(static_cast<uint32_t>(std::lround(kUnsized * ratio)));
    for (const format::TexelFormat texel : kTexels)
        if (word_of(family, candidate, kTexelName) == texel_name(texel)) s.texel = texel;
    s.used_origins = used_of(task, word_of(family, candidate, kCapName), s.origins);
    s.samples = task.samples;
    s.max_error_levels = task.max_error_levels;
    s.seed = task.seed;
    s.threads = task.threads;
    return plan;
}

}  // namespace lumi::planner
