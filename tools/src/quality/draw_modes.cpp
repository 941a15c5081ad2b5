// SPDX-License-Identifier: MIT
#include "quality/draw_modes.h"

#include <utility>

#include "lumi/detail/lattice.h"

namespace lumi::quality
{

namespace
{

using tools::DrawSettings;
using tools::Mode;

bool set_reconstruction(std::string_view word, DrawSettings& settings)
{
    for (const Mode mode : {Mode::nearest, Mode::linear})
        if (word == name_of(mode)) {
            settings.mode = mode;
            return true;
        }
    const std::string_view paper = name_of(Mode::paper);
    if (word.size() != paper.size() + 1 || word.substr(0, paper.size()) != paper) return false;
    settings.mode = Mode::paper;
    settings.neighbours = static_cast<uint32_t>(word.back() - '0');
    return word.back() >= '1' && settings.neighbours <= detail::kMaxNeighbours;
}

bool set_span(std::string_view word, DrawSettings& settings)
{
    constexpr std::pair<std::string_view, int32_t> kSpans[] = {{"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}};
    for (const auto& [name, span] : kSpans)
        if (word == name) settings.span_px = span;
    return settings.span_px > 0 && settings.mode != Mode::paper;
}

}  // namespace

std::optional<DrawMode> parse_draw_mode(std::string_view text)
{
    DrawMode mode = {std::string(text), {}};
    const size_t slash = text.find('/');
    if (!set_reconstruction(text.substr(0, slash), mode.settings)) return std::nullopt;
    if (slash != std::string_view::npos && !set_span(text.substr(slash + 1), mode.settings)) return std::nullopt;
    return mode;
}

}  // namespace lumi::quality
