// SPDX-License-Identifier: MIT
#include "planner/speed.h"

#include <charconv>

namespace lumi::planner
{

namespace
{

using tools::Mode;

// Instructions with M4 code and with M0+ code.
struct Cost {
    double m4, m0plus;

    double of(bool is_m0plus) const { return is_m0plus ? m0plus : m4; }
};

constexpr double kSpherePx = 42300;  // out of 57,600: the corners and a margin are background
// A fill of the background, a pixel.
constexpr Cost kBackground = {3, 4};
// Chord fields by render_spans, S = 8, per pixel of the sphere: docs/log/tradeoff.md, the dearest texel format.
constexpr Cost kChord[] = {{119, 206}, {204, 369}, {489, 1005}};  // by chord_kind()

// Misses per pixel of an RP2040's cache, of 8-byte lines: docs/log/tradeoff.md.
constexpr double kMisses[] = {0.09, 0.35, 0.35};

const std::vector<ChordMode> kModes = {{"paper", Mode::paper}, {"linear", Mode::linear}, {"nearest", Mode::nearest}};

size_t chord_kind(Mode mode)
{
    return mode == Mode::nearest ? 0 : mode == Mode::linear ? 1 : 2;
}

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

FrameCost frame_cost(const std::string& core, const ChordMode& mode)
{
    const bool m0plus = core == "m0plus";
    const size_t kind = chord_kind(mode.mode);
    const double background = kDisplayBits / 16 * kBackground.of(m0plus);
    return {kSpherePx * kChord[kind].of(m0plus) + background, kSpherePx * kMisses[kind]};
}

double modelled_rate(const Chip& chip, const ChordMode& mode)
{
    const FrameCost cost = frame_cost(chip.core, mode);
    return frames_per_second(chip, static_cast<uint64_t>(cost.instructions), static_cast<uint64_t>(cost.misses));
}

}  // namespace lumi::planner
