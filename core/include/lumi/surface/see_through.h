// SPDX-License-Identifier: MIT
// Surface fields with see-through parts, such as windows and bottles: SeeThroughField takes the place of SurfaceField,
// SeeThroughFrame that of SurfaceFrame. Functions have the same names and rules. Fields without such parts show the
// same pixels as without this header.
//
// Opaque triangles are drawn first. Then those see-through triangles that face the eye are blended over them, in the
// order of the file if it says so, else from far to near by the depth of their nearest corner; ties keep the order of
// the file. So every rectangle of the image shows the same pixels. They write no depth. Two see-through surfaces that
// cut each other are wrong along the cut. Outlines of see-through parts are antialiased over a colour, but not over
// nothing and not over a stripe's own content.
//
//     SeeThroughField field;  open_surface(bytes, size, field);
//     SeeThroughFrame frame;  prepare_surface<PixelRgb565>(field, camera, SurfaceMode::one_sample, memory, frame);
//     render_surface<PixelRgb565>(frame, OverBlack(), stripe, samples);
#pragma once
#pragma GCC system_header

#include "lumi/surface/detail/see_through_samples.h"
#include "lumi/surface/render.h"

namespace lumi
{

template <class Pixel, SurfaceMode kFinest = SurfaceMode::two_by_two, class Background>
void render_surface(const SeeThroughFrame& frame, const Background& background, const Stripe& stripe, void* samples)
{
    const SurfaceFrame& opaque = frame;
    if (frame.order_count == 0) return render_surface<Pixel, kFinest>(opaque, background, stripe, samples);
    const detail::DrawnPart part = detail::drawn_part(frame, stripe);
    detail::fill_around<Pixel>(background, stripe, part);
    if (part.is_empty()) return;
    if constexpr (kFinest == SurfaceMode::two_by_two)
        if (frame.mode == SurfaceMode::two_by_two)
            return detail::draw_see_through_part<detail::FourSamples<Pixel>, Pixel, kFinest>(frame, background, stripe,
                                                                                             part, samples);
    using Samples = typename detail::OneSampleOf<Pixel>::Type;
    detail::draw_see_through_part<Samples, Pixel, kFinest>(frame, background, stripe, part, samples);
}

inline void render_coverage(const SeeThroughFrame& frame, const Stripe& coverage, void* samples)
{
    const SurfaceFrame& opaque = frame;
    if (frame.order_count == 0) return render_coverage(opaque, coverage, samples);
    const detail::DrawnPart part = detail::drawn_part(frame, coverage);
    detail::fill_around<PixelA8>(OverNothing{}, coverage, part);
    if (part.is_empty()) return;
    const detail::SampleRows rows = detail::samples_of(frame, part, frame.samples_are_pixels, samples);
    const detail::StripeSamples of_stripe = {frame, rows, part, coverage};
    for (int32_t y = part.top_px; y < part.bottom_px; ++y) detail::store_see_through_coverage(of_stripe, y);
}

}  // namespace lumi
