// SPDX-License-Identifier: MIT
// Draws a guided field as firmware does: by core, stripe by stripe, in a display's pixel format.
#pragma once

#include "draw/draw.h"
#include "draw/views.h"
#include "lumi/guided/guided_field.h"

namespace lumi::tools
{

// Steps down from the best that a field offers; a field without a chart shows its mean in every mode.
enum class GuidedMode : uint8_t {
    linear,      // three origins, three taps each
    nearest,     // three origins, the nearest texel each
    one_origin,  // one origin, one texel
    mean,        // the mean colour alone; fields without one are drawn by one_origin
};

struct GuidedDrawSettings {
    GuidedMode mode = GuidedMode::linear;
    bool antialiased = true;  // four samples a pixel at the proxy's edges; a focus surface has no edges
    DisplayFormat display = DisplayFormat::rgb888;
    Rgb8 background = {0, 0, 0};
};

// The whole image, as a display of that format would show it. Leaves by Interrupted between stripes. Precondition:
// the field's bytes lie at an address divisible by 4, as those of a FieldFile do. Throws UsageError for an eye that
// core refuses.
Picture draw_guided(const GuidedField& field, const Eye& eye, const GuidedDrawSettings& settings = {});

}  // namespace lumi::tools
