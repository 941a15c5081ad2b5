// SPDX-License-Identifier: MIT
// Draws a surface field into stripes of pixels: fills the triangles that reach a stripe into a buffer of depths and
// colours, then turns samples into pixels.
//
//     uint8_t samples[surface_stripe_bytes(240, 16, SurfaceMode::one_sample)];  // at an address divisible by 4
//     render_surface<PixelRgb565>(frame, OverBlack(), stripe, samples);         // frame: prepare_surface, once
//
// A stripe may be any rectangle of the image, or beside it. Stripes may be drawn in any order, and on several cores at
// once with a buffer of samples each. Any rectangle shows the same pixels as any other.
//
// Opaque triangles are drawn first. Then those see-through triangles that face the eye, such as windows and bottles,
// are blended over them, in the order of the file if it says so, else from far to near by the depth of their nearest
// corner; ties keep the order of the file. They write no depth. Two see-through surfaces that cut each other are wrong
// along the cut. Their outlines are antialiased over a colour, but not over nothing and not over a stripe's own
// content.
#pragma once
#pragma GCC system_header

#include "lumi/background.h"
#include "lumi/surface/detail/see_through.h"

namespace lumi::detail
{

// `are_pixels`: where modes allow it, samples hold pixels.
constexpr uint32_t stripe_bytes(int32_t width_px, int32_t height_px, SurfaceMode mode, bool are_pixels)
{
    const int32_t margin = mode == SurfaceMode::antialiased ? 2 : 0, side = mode == SurfaceMode::two_by_two ? 2 : 1;
    const uint32_t colour_bytes = are_pixels && side == 1 ? sizeof(uint16_t) : sizeof(PackedColour);
    return sample_bytes(static_cast<uint32_t>((width_px + margin) * side),
                        static_cast<uint32_t>((height_px + margin) * side), colour_bytes, margin != 0);
}

constexpr uint32_t stripe_bytes_up_to(int32_t width_px, int32_t height_px, SurfaceMode finest, bool are_pixels)
{
    constexpr SurfaceMode kModes[] = {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two};
    uint32_t most = 0;
    for (const SurfaceMode mode : kModes) {
        const uint32_t bytes = stripe_bytes(width_px, height_px, mode, are_pixels);
        if (mode <= finest && bytes > most) most = bytes;
    }
    return most;
}

}  // namespace lumi::detail

namespace lumi
{

// Counts the bytes of a stripe's samples, for any pixels: a colour and a depth each. Outlines are blended with the
// pixels around the stripe.
constexpr uint32_t surface_stripe_bytes(int32_t width_px, int32_t height_px, SurfaceMode mode)
{
    const uint32_t pixels = detail::stripe_bytes(width_px, height_px, mode, true);
    const uint32_t packed = detail::stripe_bytes(width_px, height_px, mode, false);
    return pixels > packed ? pixels : packed;
}

// Returns them for one format of pixels: those of 5, 6 and 5 bits take less.
template <class Pixel>
constexpr uint32_t surface_stripe_bytes(int32_t width_px, int32_t height_px, SurfaceMode mode)
{
    return detail::stripe_bytes(width_px, height_px, mode, detail::kIsSample<Pixel>);
}

// Counts them for every mode up to the finest: the smallest stripes, up to 1 × 5 pixels, take more for the margin of
// `antialiased` than for the samples of `two_by_two`.
constexpr uint32_t surface_stripe_bytes_up_to(int32_t width_px, int32_t height_px, SurfaceMode finest)
{
    const uint32_t pixels = detail::stripe_bytes_up_to(width_px, height_px, finest, true);
    const uint32_t packed = detail::stripe_bytes_up_to(width_px, height_px, finest, false);
    return pixels > packed ? pixels : packed;
}

template <class Pixel>
constexpr uint32_t surface_stripe_bytes_up_to(int32_t width_px, int32_t height_px, SurfaceMode finest)
{
    return detail::stripe_bytes_up_to(width_px, height_px, finest, detail::kIsSample<Pixel>);
}

}  // namespace lumi

namespace lumi::detail
{

// Writes the background where nothing is drawn.
template <class Pixel, class Background>
void fill_around(const Background& background, const Stripe& stripe, const Stripe& covered)
{
    const int32_t left = covered.x_px, right = left + covered.width_px;
    const int32_t top = covered.y_px, bottom = top + covered.height_px, end = stripe.bottom_px();
    for (int32_t y = stripe.y_px; y < end; ++y) {
        const bool is_covered = y >= top && y < bottom;
        fill_beside<Pixel>(background, stripe, is_covered ? Extent{left, right} : Extent{stripe.x_px, stripe.x_px}, y);
    }
}

// Marks outlines of opaque triangles, or of all. A mark would take most of what tells a sample's coverage, and a
// stripe's content beside it is not known: over these, see-through triangles have none.
template <class Background, SurfaceFeatures kFeatures>
void mark_all_outlines(const SurfaceFrame& frame, const Target& target)
{
    mark_outlines(frame, target);
    if constexpr (has(kFeatures, SurfaceFeatures::see_through)) {
        if (frame.see_through_triangles == 0) return;
        if constexpr (!Background::kFills)
            unmark_glass(target);
        else if constexpr (!kKeepsCoverage<Background>)
            mark_see_through_outlines(frame, target);
    }
}

}  // namespace lumi::detail

namespace lumi
{

// Draws every pixel of the stripe: over a constant colour all of them are written, over the stripe's own content only
// those that the surface covers. `memory`: surface_stripe_bytes() of the stripe for its samples, at an address
// divisible by 4. The frame was prepared for these pixels, with these features, in a mode up to kFinest: what finer
// modes and other features take is not linked.
template <class Pixel, SurfaceMode kFinest = SurfaceMode::two_by_two,
          SurfaceFeatures kFeatures = SurfaceFeatures::view_tables, class Background>
void render_surface(const SurfaceFrame& frame, const Background& background, const Stripe& stripe, void* memory)
{
    using namespace detail;
    constexpr bool kMayHaveGlass = has(kFeatures, SurfaceFeatures::see_through);
    constexpr bool kMayMove = has(kFeatures, SurfaceFeatures::parts);
    using Pieces = typename PiecesFor<kMayMove, TrianglePieces, MovingPieces>::Type;
    using Glossy = typename PiecesFor<kMayMove, GlossPieces, MovingGlossPieces>::Type;
    using SeeThrough = typename PiecesFor<kMayMove, SeeThroughPieces, MovingSeeThroughPieces>::Type;
    const Stripe covered = covered_part(frame, stripe, Pixel::kBytes);
    fill_around<Pixel>(background, stripe, covered);
    if (covered.width_px == 0) return;
    const auto draw_opaque = [&](const Target& target, auto loop, auto magnified, auto gloss, auto magnified_gloss) {
        if constexpr (has(kFeatures, SurfaceFeatures::gloss))
            if (gloss_count(frame.field) != 0)
                return draw_glossy_triangles<Glossy, loop.kDraw, magnified.kDraw, gloss.kDraw, magnified_gloss.kDraw>(
                    frame, target);
        draw_triangles<Pieces, loop.kDraw, magnified.kDraw>(frame, target);
    };
    const auto draw_as = [&](auto kind) {
        using Samples = typename decltype(kind)::Type;
        constexpr bool kHasTaps = kFinest != SurfaceMode::one_sample && Samples::kSide == 1;
        const Target target = target_of(frame, covered, stripe.x_px, Samples::kArePixels, memory);
        const Samples samples = {{frame, target, covered}};
        samples.clear(background);
        if constexpr (kMayHaveGlass && !Samples::kArePixels)
            if (frame.see_through_triangles != 0) fill_colours<Pixel>(samples, background);
        if (kHasTaps && frame.mode == SurfaceMode::antialiased) {
            draw_opaque(target, Loop<Samples::kRows.two_taps>{}, Loop<Samples::kRows.bilinear>{},
                        GlossLoop<Samples::kGloss.two_taps>{}, GlossLoop<Samples::kGloss.bilinear>{});
            if constexpr (kMayHaveGlass)
                if (frame.see_through_triangles != 0)
                    draw_triangles<SeeThrough, Samples::kBlends.two_taps, Samples::kBlends.bilinear>(frame, target);
            if (frame.margin != 0) mark_all_outlines<Background, kFeatures>(frame, target);
        } else {
            draw_opaque(target, Loop<Samples::kRows.nearest>{}, Loop<Samples::kMagnifiedRows>{},
                        GlossLoop<Samples::kGloss.nearest>{}, GlossLoop<Samples::kMagnifiedGloss>{});
            if constexpr (kMayHaveGlass)
                if (frame.see_through_triangles != 0)
                    draw_triangles<SeeThrough, Samples::kBlends.nearest, Samples::kMagnifiedBlends>(frame, target);
        }
        const int32_t end = covered.y_px + covered.height_px;
        for (int32_t y = covered.y_px; y < end; ++y) {
            samples.template resolve<kFinest>(background, y);
            if constexpr (kMayHaveGlass && kKeepsCoverage<Background>)
                if (frame.see_through_triangles != 0) store_glass<Pixel>(samples, y);
        }
    };
    if constexpr (kFinest == SurfaceMode::two_by_two)
        if (frame.mode == SurfaceMode::two_by_two) return draw_as(KindOf<FourSamples<Pixel>>{});
    draw_as(OneSampleOf<Pixel>{});
}

// Stores the coverage of the stripe that render_surface drew last into these samples, a byte a pixel: `coverage` has
// that stripe's place and size in the image. Colours over nothing and this are the planes of LVGL's RGB565A8.
template <SurfaceFeatures kFeatures = SurfaceFeatures::view_tables>
void render_coverage(const SurfaceFrame& frame, const Stripe& coverage, void* memory)
{
    const Stripe covered = detail::covered_part(frame, coverage, PixelA8::kBytes);
    detail::fill_around<PixelA8>(OverNothing{}, coverage, covered);
    if (covered.width_px == 0) return;
    const detail::Target target = detail::target_of(frame, covered, coverage.x_px, frame.samples_are_pixels, memory);
    const detail::StripeSamples samples = {frame, target, covered};
    for (int32_t y = covered.y_px; y < covered.y_px + covered.height_px; ++y) {
        if constexpr (has(kFeatures, SurfaceFeatures::see_through)) {
            if (frame.see_through_triangles != 0) {
                detail::store_see_through_coverage(samples, y);
                continue;
            }
        }
        detail::store_coverage(samples, y);
    }
}

}  // namespace lumi
