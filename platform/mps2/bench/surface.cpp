// SPDX-License-Identifier: MIT
// The surface renderer for the pixels that the build names: LUMI_BENCH_PIXEL.
#include "surface_instance.h"

namespace lumi::bench
{
namespace
{

using Pixel = LUMI_BENCH_PIXEL;

constexpr uint32_t kStrideBytes = kSidePx * Pixel::kBytes;

SurfaceFrame frame;
SurfaceVertex vertices[detail::format::kMaxSurfaceVertices];
uint16_t links[surface_links(detail::format::kMaxPatches)];
uint16_t bands[surface_bands(kSidePx, kSurfaceBandLog2)];
uint32_t samples[surface_stripe_bytes(kSidePx, kSurfaceStripeHeight, SurfaceMode::two_by_two) / sizeof(uint32_t)];

}  // namespace

const uint32_t kSurfaceFrameBytes = kSidePx * kStrideBytes;

void prepare_alone(const SurfaceField& field, const SurfaceView& view)
{
    prepare_surface<Pixel>(field, view.camera, view.mode, {vertices, links, bands, kSurfaceBandLog2}, frame);
}

void fill_alone(int32_t width_px, bool with_outlines)
{
    SurfaceFrame filled = frame;
    if (!with_outlines) filled.field.neighbours = nullptr;
    const int32_t margin = detail::blends_outlines(filled) ? 1 : 0;
    for (int32_t y = 0; y < kSidePx; y += kSurfaceStripeHeight) {
        const int32_t top = y - margin < 0 ? 0 : y - margin, end = y + kSurfaceStripeHeight + margin;
        const int32_t rows = (end < kSidePx ? end : kSidePx) - top;
        const uint32_t count = static_cast<uint32_t>(width_px * rows) << (2 * frame.samples_log2);
        detail::rasterize(filled, {0, top, width_px, rows}, reinterpret_cast<uint16_t*>(samples + count), samples);
    }
}

void draw_surface(const SurfaceField& field, const SurfaceView& view, uint8_t* pixels)
{
    prepare_alone(field, view);
    for (int32_t y = 0; y < kSidePx; y += kSurfaceStripeHeight) {
        uint8_t* const at = pixels + static_cast<uint32_t>(y) * kStrideBytes;
        render_surface<Pixel>(frame, kBackground, {at, 0, y, kSidePx, kSurfaceStripeHeight, kStrideBytes}, samples);
    }
}

}  // namespace lumi::bench
