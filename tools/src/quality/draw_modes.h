// SPDX-License-Identifier: MIT
// Ways to draw a chord field, as words name them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "draw/draw.h"

namespace lumi::quality
{

struct DrawMode {
    std::string name;  // as it was given
    tools::DrawSettings settings;
};

inline constexpr const char* kDrawModeWords =
    "nearest, linear or paperK with K from 1 to 9; the first two also with /S for spans "
    "of S = 2, 4, 8 or 16 pixels, for instance linear/8";

// "linear", "paper9", "nearest/8"; nothing for other words.
std::optional<DrawMode> parse_draw_mode(std::string_view text);

}  // namespace lumi::quality
