// SPDX-License-Identifier: MIT
// Draws a surface field as firmware does: by core, stripe by stripe, in a display's pixel format.
#pragma once

#include <string>
#include <vector>

#include "draw/draw.h"
#include "draw/views.h"
#include "image/picture.h"
#include "lumi/surface/frame.h"

namespace lumi::tools
{

// A moving part in a pose: turns times 2^32, or the offset of one that slides, Q20.
struct PartValue {
    uint32_t part, value;
};

// The weight of a light state.
struct StateValue {
    uint32_t state;
    StateWeight weight;
};

// People say so of a part: degrees, or scene units; from the first view of a turntable up to the next round.
struct PartPose {
    std::string name;
    double from = 0, to = 0;
};

struct SurfaceDrawSettings {
    SurfaceMode mode = SurfaceMode::two_by_two;
    DisplayFormat display = DisplayFormat::rgb888;
    Rgb8 background = {0, 0, 0};
    std::vector<PartValue> parts = {};    // others rest
    std::vector<StateValue> states = {};  // others have all of their light
};

// Returns "one-sample", "antialiased" or "2x2".
const char* name_of(SurfaceMode mode);

// The whole image, as a display of that format would show it. Leaves by Interrupted between stripes. Throws UsageError
// for an eye that core refuses.
Picture draw_surface(const SurfaceField& field, const Eye& eye, const SurfaceDrawSettings& settings = {});

// The depths of opaque parts in the pixels' centres, as the renderer has them (surface/frame.h). Throws UsageError
// likewise.
Plane<uint16_t> surface_depths(const SurfaceField& field, const Eye& eye);

}  // namespace lumi::tools
