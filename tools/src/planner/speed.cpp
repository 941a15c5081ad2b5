// SPDX-License-Identifier: MIT
#include "planner/speed.h"

#include <charconv>
#include <string_view>

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

namespace
{

// "30fps"; nothing for other texts and rates that are not above 0.
std::optional<double> parse_rate(std::string_view text)
{
    constexpr std::string_view kUnit = "fps";
    constexpr double kMost = 1e6;
    if (text.size() <= kUnit.size() || text.substr(text.size() - kUnit.size()) != kUnit) return std::nullopt;
    const char* const end = text.data() + text.size() - kUnit.size();
    double rate = 0;
    const auto [stop, error] = std::from_chars(text.data(), end, rate);
    if (error != std::errc() || stop != end || !(rate > 0) || rate > kMost) return std::nullopt;
    return rate;
}

}  // namespace

std::optional<Pace> parse_pace(const std::string& text)
{
    const size_t at = text.find('@');
    const std::optional<double> rate =
        at == std::string::npos ? kUsualPace : parse_rate(std::string_view(text).substr(at + 1));
    if (!rate) return std::nullopt;
    for (const Chip& chip : kChipList)
        if (text.substr(0, at) == chip.key) return Pace{&chip, *rate};
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
