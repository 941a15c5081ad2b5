// SPDX-License-Identifier: MIT
// The surface renderer under test, for the pixels that the build names: each bench program links exactly one. Memory
// lies in the program; one frame is prepared at a time.
#pragma once

#include "lumi/bench/surface_modes.h"

namespace lumi::bench
{

struct SurfaceView {
    const SurfaceCamera& camera;
    SurfaceMode mode;
};

// Bytes of a frame of pixels.
extern const uint32_t kSurfaceFrameBytes;

// Draws a whole frame: prepares it and draws every stripe, at most kTallStripeHeight high.
void draw_surface(const SurfaceField& field, const SurfaceView& view, int32_t stripe_height, uint8_t* pixels);

// The first part of that.
void prepare_alone(const SurfaceField& field, const SurfaceView& view, int32_t stripe_height);

// Fills the stripes of the frame that was prepared last, its first `width_px` columns, and makes no pixels of them.
// Outlines are blended or not.
void fill_alone(int32_t width_px, bool with_outlines);

}  // namespace lumi::bench
