// SPDX-License-Identifier: MIT
// The surface renderer for the pixels, parts and modes that the build names: LUMI_BENCH_PIXEL, LUMI_BENCH_SEE_THROUGH,
// LUMI_BENCH_FINEST, LUMI_BENCH_VIEW_TABLES, LUMI_BENCH_STATES and LUMI_BENCH_GLOSS.
#include <algorithm>

#include "lumi/mps2/meters.h"
#include "surface_instance.h"

namespace lumi::bench
{
namespace
{

using Pixel = LUMI_BENCH_PIXEL;
constexpr SurfaceMode kFinest = SurfaceMode::LUMI_BENCH_FINEST;

constexpr uint32_t kStrideBytes = kSidePx * Pixel::kBytes;

// Draws the opaque triangles and their outlines.
template <class Samples>
void fill(const SurfaceFrame& filled, const detail::Target& target)
{
    using detail::TrianglePieces;
    if (Samples::kSide == 2 || filled.mode == SurfaceMode::one_sample)
        return detail::draw_triangles<TrianglePieces, Samples::kRows.nearest, Samples::kMagnifiedRows>(filled, target);
    if constexpr (kFinest != SurfaceMode::one_sample) {
        detail::draw_triangles<TrianglePieces, Samples::kRows.two_taps, Samples::kRows.bilinear>(filled, target);
        if (filled.margin != 0) detail::mark_outlines(filled, target);
    }
}

SurfaceFrame frame;
constexpr uint32_t kMostStates = LUMI_BENCH_STATES ? detail::format::kMaxStates : 0;
constexpr uint32_t kMostMaps = LUMI_BENCH_GLOSS ? detail::format::kMaxGlossMaps : 0;
detail::SampleMemory<4 * (see_through_words(LUMI_BENCH_SEE_THROUGH) + state_words(kMostStates, LUMI_BENCH_SEE_THROUGH) +
                          gloss_words(kMostMaps, detail::format::kMaxSurfaceVertices))>
    features;
SurfaceVertex vertices[detail::format::kMaxSurfaceVertices];
uint16_t links[surface_links(detail::format::kMaxPatches)];
constexpr uint32_t kBands = surface_bands(kSidePx, surface_band_log2(kTallStripeHeight));
uint16_t bands[kBands], second_bands[kBands];
uint32_t samples[surface_stripe_bytes(kSidePx, kTallStripeHeight, kFinest) / sizeof(uint32_t)];

}  // namespace

const uint32_t kSurfaceFrameBytes = kSidePx * kStrideBytes;

void weigh([[maybe_unused]] SurfaceField& field)
{
    if constexpr (has(kFeatures, SurfaceFeatures::states)) {
        constexpr uint16_t kHalf = kFullWeight / 2, kQuarter = kFullWeight / 4;
        static bool is_second = false;
        const uint16_t weight = is_second ? kHalf : kQuarter;
        is_second = true;
        set_state(field, {vertices, links, bands, kSurfaceBandLog2, features.data()}, 1, {weight, weight, weight});
    }
}

void prepare_alone(const SurfaceField& field, const SurfaceView& view, int32_t stripe_height)
{
    const SurfaceMemory memory = {vertices, links, bands, surface_band_log2(stripe_height), features.data()};
    prepare_surface<Pixel, kFinest, kFeatures>(field, view.camera, view.mode, memory, frame);
}

uint64_t prepare_by_halves(const SurfaceField& field, const SurfaceView& view, int32_t stripe_height)
{
    const SurfaceMemory memory = {vertices, links, bands, surface_band_log2(stripe_height), features.data()};
    SurfaceHalves halves = {};
    halves.bands = second_bands;
    uint64_t waited = 0;
    const uint64_t begin = mps2::instructions();
    prepare_surface<Pixel, SurfaceMode::two_by_two, kFeatures>(field, view.camera, view.mode, memory, frame, halves,
                                                               [&](int32_t step) {
                                                                   const uint64_t first = mps2::instructions();
                                                                   prepare_half<kFinest, kFeatures>(halves, step, 0);
                                                                   const uint64_t second = mps2::instructions();
                                                                   prepare_half<kFinest, kFeatures>(halves, step, 1);
                                                                   const uint64_t end = mps2::instructions();
                                                                   waited += std::min(second - first, end - second);
                                                               });
    return mps2::instructions() - begin - waited;
}

void fill_alone(int32_t width_px, bool with_outlines)
{
    SurfaceFrame filled = frame;
    if (!with_outlines) filled.margin = 0;
    const bool are_pixels = filled.samples_are_pixels;
    for (int32_t y = 0; y < kSidePx; y += kSurfaceStripeHeight) {
        const Stripe stripe = {nullptr, 0, y, kSidePx, kSurfaceStripeHeight, kStrideBytes};
        Stripe covered = detail::covered_part(filled, stripe, 0);
        if (covered.width_px == 0) continue;
        if (width_px == 0) covered.width_px = 0;
        const detail::Target target = detail::target_of(filled, covered, 0, are_pixels, samples);
        if (are_pixels)
            detail::clear_pixels(target, 0);
        else
            detail::clear_depths(target);
        if (filled.mode == SurfaceMode::two_by_two)
            fill<detail::FourSamples<Pixel>>(filled, target);
        else
            fill<detail::OneSampleOf<Pixel>::Type>(filled, target);
    }
}

void draw_surface(const SurfaceField& field, const SurfaceView& view, int32_t stripe_height, uint8_t* pixels)
{
    prepare_alone(field, view, stripe_height);
    for (int32_t y = 0; y < kSidePx; y += stripe_height) {
        uint8_t* const at = pixels + static_cast<uint32_t>(y) * kStrideBytes;
        render_surface<Pixel, kFinest, kFeatures>(frame, kBackground, {at, 0, y, kSidePx, stripe_height, kStrideBytes},
                                                  samples);
    }
}

}  // namespace lumi::bench
