// SPDX-License-Identifier: MIT
// The surface renderer under test, for the pixels that the build names: each bench program links exactly one. Memory
// lies in the program; one frame is prepared at a time.
#pragma once

#include "lumi/bench/surface_modes.h"
#include "lumi/surface/view.h"

namespace lumi::bench
{

// Parts of fields that the build names, for as many see-through patches as it names.
inline constexpr SurfaceFeatures kFeatures = LUMI_BENCH_STATES  ? SurfaceFeatures::view_tables | SurfaceFeatures::states
                                             : LUMI_BENCH_GLOSS ? SurfaceFeatures::view_tables | SurfaceFeatures::gloss
                                             : LUMI_BENCH_SEE_THROUGH != 0
                                                 ? SurfaceFeatures::view_tables | SurfaceFeatures::see_through
                                             : LUMI_BENCH_VIEW_TABLES ? SurfaceFeatures::view_tables
                                                                      : SurfaceFeatures::none;

// The field without its see-through patches and gloss maps.
inline SurfaceField opaque_alone(SurfaceField field)
{
    field.see_through_count = 0;
    field.gloss = nullptr;
    return field;
}

// Memory that drawing a frame takes for them, besides surface_ram_bytes().
inline uint32_t see_through_ram_bytes(const SurfaceField& field)
{
    return static_cast<uint32_t>(sizeof(uint32_t)) * feature_words(field);
}

// The next frame shows a quarter of the light of state 1, after a second call half of it. Does nothing without states.
void weigh(SurfaceField& field);

struct SurfaceView {
    const SurfaceCamera& camera;
    SurfaceMode mode;
};

// Counts the bytes of a frame of pixels.
extern const uint32_t kSurfaceFrameBytes;

// Draws a whole frame: prepares it and draws every stripe, at most kTallStripeHeight high.
void draw_surface(const SurfaceField& field, const SurfaceView& view, int32_t stripe_height, uint8_t* pixels);

// Does the first part of that.
void prepare_alone(const SurfaceField& field, const SurfaceView& view, int32_t stripe_height);

// Does that in halves. Returns the instructions until two cores have done it, which are those of each longer half.
uint64_t prepare_by_halves(const SurfaceField& field, const SurfaceView& view, int32_t stripe_height);

// Fills the stripes of the frame that was prepared last, its first `width_px` columns, with opaque triangles, and makes
// no pixels of them. Outlines are blended or not.
void fill_alone(int32_t width_px, bool with_outlines);

}  // namespace lumi::bench
