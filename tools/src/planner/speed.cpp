// SPDX-License-Identifier: MIT
#include "planner/speed.h"

#include <charconv>
#include <stdexcept>

namespace lumi::planner
{

namespace
{

using tools::GuidedMode;
using tools::Mode;

// Instructions with M4 code and with M0+ code.
struct Cost {
    double m4, m0plus;

    double of(bool is_m0plus) const { return is_m0plus ? m0plus : m4; }
};

// A fill of the background, a pixel.
constexpr Cost kBackground = {3, 4};
// Guided fields, measured on whole frames of M = 128, G = 96, 2,500 triangles (docs/log/quality.md). A triangle with
// its share of the vertices; an object pixel's surface with one sample, and with four and their mixing; its shading by
// GuidedMode.
constexpr Cost kTriangle = {154, 262}, kSurface = {119, 187}, kFourSamples = {267, 381};
constexpr Cost kShade[] = {{705, 1287}, {640, 1202}, {434, 808}, {190, 362}};
// What texels in blocks cost more, where taps are linear.
constexpr Cost kBlocks = {120, 250};
// A ray against the focus sphere, per pixel of the sphere: assumed.
constexpr Cost kFocusPixel = {60, 110};

// Chord fields by render_spans, S = 8, per pixel of the sphere: docs/log/tradeoff.md, the dearest texel format.
constexpr Cost kChord[] = {{119, 206}, {204, 369}, {489, 1005}};  // by chord_kind()

// Misses per pixel of an RP2040's cache, of 8-byte lines. Chord fields: docs/log/tradeoff.md. Guided ones: neighbouring
// pixels read texels half a step apart, 16 to a line in each of three origins' rows, and voxels of four rows.
constexpr double kChordMisses[] = {0.09, 0.35, 0.35};
constexpr double kGuidedMisses[] = {0.7, 0.6, 0.5, 0.4};

const std::vector<DrawMode> kGuided = {{"linear, antialiased", GuidedMode::linear, true, Mode::linear},
                                       {"nearest, antialiased", GuidedMode::nearest, true, Mode::linear},
                                       {"linear", GuidedMode::linear, false, Mode::linear},
                                       {"nearest", GuidedMode::nearest, false, Mode::linear},
                                       {"one-origin", GuidedMode::one_origin, false, Mode::linear},
                                       {"mean", GuidedMode::mean, false, Mode::linear}};
const std::vector<DrawMode> kFocus = {{"linear", GuidedMode::linear, false, Mode::linear},
                                      {"nearest", GuidedMode::nearest, false, Mode::linear},
                                      {"one-origin", GuidedMode::one_origin, false, Mode::linear}};
const std::vector<DrawMode> kChordModes = {{"paper", GuidedMode::linear, false, Mode::paper},
                                           {"linear", GuidedMode::linear, false, Mode::linear},
                                           {"nearest", GuidedMode::linear, false, Mode::nearest}};

size_t chord_kind(Mode mode)
{
    return mode == Mode::nearest ? 0 : mode == Mode::linear ? 1 : 2;
}

FrameCost guided_cost(bool m0plus, const Plan& plan, const DrawMode& mode, const FrameShare& share)
{
    const auto kind = static_cast<size_t>(mode.guided);
    if (plan.layout == Layout::focus) {
        const double pixel = kFocusPixel.of(m0plus) + kShade[kind].of(m0plus);
        return {share.sphere_px * pixel, share.sphere_px * kGuidedMisses[kind]};
    }
    const double mesh = plan.guided.proxy_triangles * kTriangle.of(m0plus);
    const bool has_blocks = plan.guided.texel == format::GuidedTexel::vq8 && mode.guided == GuidedMode::linear;
    const double pixel = (mode.antialiased ? kFourSamples : kSurface).of(m0plus) + kShade[kind].of(m0plus) +
                         (has_blocks ? kBlocks.of(m0plus) : 0);
    return {mesh + share.object_px * pixel, share.object_px * kGuidedMisses[kind]};
}

}  // namespace

const std::vector<DrawMode>& modes_of(Layout layout)
{
    switch (layout) {
        case Layout::guided:
            return kGuided;
        case Layout::focus:
            return kFocus;
        case Layout::chord:
            return kChordModes;
    }
    throw std::logic_error("unknown layout");
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
    for (const bench::Chip& chip : bench::kChipList)
        if (text.substr(0, at) == chip.key) return Pace{&chip, rate};
    return std::nullopt;
}

std::string chip_names()
{
    std::string text;
    for (size_t k = 0; k < bench::kChips; ++k)
        text += (k == 0 ? "" : k + 1 == bench::kChips ? " or " : ", ") + std::string(bench::kChipList[k].key);
    return text;
}

FrameCost frame_cost(const std::string& core, const Plan& plan, const DrawMode& mode, const FrameShare& share)
{
    const bool m0plus = core == "m0plus";
    FrameCost cost;
    if (plan.layout == Layout::chord) {
        const auto kind = chord_kind(mode.chord);
        cost = {share.sphere_px * kChord[kind].of(m0plus), share.sphere_px * kChordMisses[kind]};
    } else {
        cost = guided_cost(m0plus, plan, mode, share);
    }
    cost.instructions += bench::kDisplayBits / 16 * kBackground.of(m0plus);
    return cost;
}

double modelled_rate(const bench::Chip& chip, const Plan& plan, const DrawMode& mode, const FrameShare& share)
{
    const FrameCost cost = frame_cost(chip.core, plan, mode, share);
    return bench::frames_per_second(chip, static_cast<uint64_t>(cost.instructions), static_cast<uint64_t>(cost.misses));
}

std::vector<DrawMode> affordable_modes(const std::optional<Pace>& pace, const Plan& plan, const FrameShare& share)
{
    std::vector<DrawMode> modes = modes_of(plan.layout);
    if (!pace) {
        // What `lumi render` draws without --mode.
        return {plan.layout == Layout::chord ? modes[1] : modes[0]};
    }
    std::vector<DrawMode> affordable;
    for (const DrawMode& mode : modes)
        if (modelled_rate(*pace->chip, plan, mode, share) >= pace->frames_per_second) affordable.push_back(mode);
    return affordable;
}

}  // namespace lumi::planner
