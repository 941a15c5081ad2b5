// SPDX-License-Identifier: MIT
// The surface renderer under test, for the pixels that the build names: each bench program links exactly one. Memory
// lies in the program; one frame is prepared at a time.
#pragma once

#include "lumi/bench/surface_modes.h"
#include "lumi/surface/view.h"

namespace lumi::bench
{

// A field, its frame and what else drawing takes, for as many see-through patches as the build names.
using SurfaceParts = detail::SurfaceParts<LUMI_BENCH_SEE_THROUGH>;
using BenchField = SurfaceParts::Field;

// The field without its see-through patches.
inline SurfaceField opaque_alone(const SurfaceField& field)
{
    return field;
}
inline SeeThroughField opaque_alone(SeeThroughField field)
{
    field.see_through_count = 0;
    return field;
}

// Memory that drawing a frame takes for them, besides surface_ram_bytes().
inline uint32_t see_through_ram_bytes(const SurfaceField&)
{
    return 0;
}
inline uint32_t see_through_ram_bytes(const SeeThroughField& field)
{
    return static_cast<uint32_t>(sizeof(SeeThroughFrame) - sizeof(SurfaceFrame)) +
           static_cast<uint32_t>(sizeof(uint32_t)) * see_through_order(field.see_through_count);
}

struct SurfaceView {
    const SurfaceCamera& camera;
    SurfaceMode mode;
};

// Bytes of a frame of pixels.
extern const uint32_t kSurfaceFrameBytes;

// Draws a whole frame: prepares it and draws every stripe, at most kTallStripeHeight high.
void draw_surface(const BenchField& field, const SurfaceView& view, int32_t stripe_height, uint8_t* pixels);

// The first part of that.
void prepare_alone(const BenchField& field, const SurfaceView& view, int32_t stripe_height);

// As prepare_alone(), in halves. Instructions until two cores have done it: of each step those of the longer half.
uint64_t prepare_by_halves(const BenchField& field, const SurfaceView& view, int32_t stripe_height);

// Fills the stripes of the frame that was prepared last, its first `width_px` columns, with opaque triangles, and makes
// no pixels of them. Outlines are blended or not.
void fill_alone(int32_t width_px, bool with_outlines);

}  // namespace lumi::bench
