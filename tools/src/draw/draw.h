// SPDX-License-Identifier: MIT
// Draws a field as firmware does: by core, stripe by stripe, in a display's pixel format.
#pragma once

#include "image/picture.h"
#include "lumi/chord/camera.h"
#include "lumi/chord/field.h"

namespace lumi::tools
{

enum class Mode : uint8_t { nearest, linear, paper };
// Returns "nearest", "linear" or "paper".
const char* name_of(Mode mode);

enum class DisplayFormat : uint8_t { rgb888, rgb565, rgb565_dithered, grey8 };

inline constexpr uint32_t kDefaultNeighbours = 5;

struct DrawSettings {
    Mode mode = Mode::linear;
    uint32_t neighbours = kDefaultNeighbours;  // 1 .. kMaxNeighbours; for Mode::paper
    DisplayFormat display = DisplayFormat::rgb888;
    Rgb8 background = {0, 0, 0};
    int32_t span_px = 0;  // as render_spans() takes it; 0, 1 and Mode::paper draw every pixel exactly
};

// The whole image of `camera`, as a display of that format would show it. Leaves by Interrupted between stripes.
Picture draw(const Field& field, const Camera& camera, const DrawSettings& settings);

}  // namespace lumi::tools
