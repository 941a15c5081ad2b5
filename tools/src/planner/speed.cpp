// SPDX-License-Identifier: MIT
#include "planner/speed.h"

#include <charconv>

namespace lumi::planner
{

namespace
{

using tools::Mode;

const std::vector<ChordMode> kModes = {{"paper", Mode::paper}, {"linear", Mode::linear}, {"nearest", Mode::nearest}};

}  // namespace

const std::vector<ChordMode>& chord_modes()
{
    return kModes;
}

std::optional<Pace> parse_pace(const std::string& text)
{
    constexpr char kUnit[] = "fps";
    const size_t at = text.find('@');
    if (at == std::string::npos || text.size() < at + sizeof kUnit) return std::nullopt;
    const size_t end = text.size() - (sizeof kUnit - 1);
    double rate = 0;
    const auto [stop, error] = std::from_chars(text.data() + at + 1, text.data() + end, rate);
    if (error != std::errc() || stop != text.data() + end || text.substr(end) != kUnit) return std::nullopt;
    if (!(rate > 0) || rate > 1e6) return std::nullopt;
    for (const Chip& chip : kChipList)
        if (text.substr(0, at) == chip.key) return Pace{&chip, rate};
    return std::nullopt;
}

std::string chip_names()
{
    std::string text;
    for (size_t k = 0; k < kChips; ++k)
        text += (k == 0 ? "" : k + 1 == kChips ? " or " : ", ") + std::string(kChipList[k].key);
    return text;
}

}  // namespace lumi::planner
