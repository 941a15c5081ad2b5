// SPDX-License-Identifier: MIT
// Draws a surface field into stripes of pixels: fills the triangles that reach a stripe into a buffer of depths and
// colours, then turns samples into pixels.
//
//     uint8_t samples[surface_stripe_bytes(240, 16, SurfaceMode::one_sample)];  // at an address divisible by 4
//     render_surface<PixelRgb565>(frame, OverBlack(), stripe, samples);         // frame: prepare_surface, once
//
// A stripe may be any rectangle of the image, or beside it. Stripes may be drawn in any order, and on several cores at
// once with a buffer of samples each. Any rectangle shows the same pixels as any other.
#pragma once
#pragma GCC system_header

#include "lumi/background.h"
#include "lumi/surface/detail/resolve.h"
#include "lumi/surface/detail/target.h"

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

// Bytes of a stripe's samples, for any pixels: a colour and a depth each. Outlines are blended with the pixels around
// the stripe.
constexpr uint32_t surface_stripe_bytes(int32_t width_px, int32_t height_px, SurfaceMode mode)
{
    const uint32_t pixels = detail::stripe_bytes(width_px, height_px, mode, true);
    const uint32_t packed = detail::stripe_bytes(width_px, height_px, mode, false);
    return pixels > packed ? pixels : packed;
}

// The same for one format of pixels: those of 5, 6 and 5 bits take less.
template <class Pixel>
constexpr uint32_t surface_stripe_bytes(int32_t width_px, int32_t height_px, SurfaceMode mode)
{
    return detail::stripe_bytes(width_px, height_px, mode, detail::kIsSample<Pixel>);
}

// And for every mode up to the finest: the smallest stripes, up to 1 × 5 pixels, take more for the margin of
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

// Fills the samples of a stripe's drawn part and makes pixels of them.
template <class Samples, SurfaceMode kFinest, class Background>
void draw_part(const SurfaceFrame& frame, const Background& background, const Stripe& stripe, const DrawnPart& part,
               void* memory)
{
    const SampleRows rows = samples_of(frame, part, Samples::kArePixels, memory);
    const Samples samples = {{frame, rows, part, stripe}};
    samples.clear(background);
    const Target target = target_of(frame, part, rows);
    samples.template draw<kFinest>(target);
    for (int32_t y = part.top_px; y < part.bottom_px; ++y) samples.template resolve<kFinest>(background, y);
}

// Writes the background where nothing is drawn.
template <class Pixel, class Background>
void fill_around(const Background& background, const Stripe& stripe, const DrawnPart& part)
{
    for (int32_t y = stripe.y_px; y < stripe.bottom_px(); ++y) {
        const bool has_drawn = !part.is_empty() && y >= part.top_px && y < part.bottom_px;
        fill_beside<Pixel>(background, stripe,
                           has_drawn ? Extent{part.left_px, part.right_px} : Extent{stripe.x_px, stripe.x_px}, y);
    }
}

}  // namespace lumi::detail

namespace lumi
{

// Draws every pixel of the stripe: over a constant colour all of them are written, over the stripe's own content only
// those that the surface covers. `samples`: surface_stripe_bytes() of the stripe, at an address divisible by 4. The
// frame was prepared for these pixels, in a mode up to kFinest: what finer modes take is not linked.
template <class Pixel, SurfaceMode kFinest = SurfaceMode::two_by_two, class Background>
void render_surface(const SurfaceFrame& frame, const Background& background, const Stripe& stripe, void* samples)
{
    const detail::DrawnPart part = detail::drawn_part(frame, stripe);
    detail::fill_around<Pixel>(background, stripe, part);
    if (part.is_empty()) return;
    if constexpr (kFinest == SurfaceMode::two_by_two)
        if (frame.mode == SurfaceMode::two_by_two)
            return detail::draw_part<detail::FourSamples<Pixel>, kFinest>(frame, background, stripe, part, samples);
    using Samples = typename detail::OneSampleOf<Pixel>::Type;
    detail::draw_part<Samples, kFinest>(frame, background, stripe, part, samples);
}

// The coverage of the stripe that render_surface drew last into these samples, a byte a pixel: `coverage` has that
// stripe's place and size in the image. Colours over nothing and this are the planes of LVGL's RGB565A8.
inline void render_coverage(const SurfaceFrame& frame, const Stripe& coverage, void* samples)
{
    const detail::DrawnPart part = detail::drawn_part(frame, coverage);
    detail::fill_around<PixelA8>(OverNothing{}, coverage, part);
    if (part.is_empty()) return;
    const detail::SampleRows rows = detail::samples_of(frame, part, frame.samples_are_pixels, samples);
    const detail::StripeSamples of_stripe = {frame, rows, part, coverage};
    for (int32_t y = part.top_px; y < part.bottom_px; ++y) detail::store_coverage(of_stripe, y);
}

}  // namespace lumi
