// SPDX-License-Identifier: MIT
// Guided fields by one kind of surface, with every policy that a field and a mode can ask for. Each surface is
// instantiated in a file of its own, so that they compile side by side.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "draw/draw_guided.h"
#include "lumi/guided/guided_render.h"
#include "lumi/guided/guided_vq.h"
#include "terminal/interrupt.h"

namespace lumi::tools
{

inline constexpr int kGuidedStripeRows = 16;  // what firmware with some kilobytes to spare draws at once

// Draws all stripes over the background into a picture of the display's widest format.
template <class Surface>
Picture draw_stripes(const GuidedField& field, const Camera& camera, Surface& surface, GuidedMode mode,
                     const Rgb8& background);

template <class Policy, class Surface>
Picture draw_stripes_as(const GuidedField& field, const Camera& camera, Surface& surface, const Rgb8& background)
{
    Picture picture(camera.width_px(), camera.height_px());
    const auto stride = static_cast<uint32_t>(3 * camera.width_px());
    for (int y = 0; y < camera.height_px(); y += kGuidedStripeRows) {
        leave_if_interrupted();
        const int rows = std::min(kGuidedStripeRows, camera.height_px() - y);
        const Stripe stripe = {picture.pixel(0, y), 0, y, camera.width_px(), rows, stride};
        const GuidedError error =
            render_guided<Policy, PixelRgb888>(field, camera, surface, OverColour{background}, stripe);
        if (error != GuidedError::none) throw std::logic_error(describe(error));
    }
    return picture;
}

template <class Texel, class Mean, class Surface>
Picture draw_in_mode(const GuidedField& field, const Camera& camera, Surface& surface, GuidedMode mode,
                     const Rgb8& background)
{
    constexpr auto kRead = OcclusionUse::read;
    if constexpr (Mean::kHasMean) {
        if (mode == GuidedMode::mean)
            return draw_stripes_as<GuidedPolicy<OneOrigin, NearestTap, NoChart, Mean, OcclusionUse::ignored>>(
                field, camera, surface, background);
    }
    switch (mode) {
        case GuidedMode::linear:
            return draw_stripes_as<GuidedPolicy<ThreeOrigins, LinearTaps, Texel, Mean, kRead>>(field, camera, surface,
                                                                                               background);
        case GuidedMode::nearest:
            return draw_stripes_as<GuidedPolicy<ThreeOrigins, NearestTap, Texel, Mean, kRead>>(field, camera, surface,
                                                                                               background);
        case GuidedMode::one_origin:
        case GuidedMode::mean:
            break;
    }
    return draw_stripes_as<GuidedPolicy<OneOrigin, NearestTap, Texel, Mean, kRead>>(field, camera, surface, background);
}

template <class Mean, class Surface>
Picture draw_with_mean(const GuidedField& field, const Camera& camera, Surface& surface, GuidedMode mode,
                       const Rgb8& background)
{
    switch (field.texel) {
        case format::GuidedTexel::index4:
            return draw_in_mode<GuidedIndex4, Mean>(field, camera, surface, mode, background);
        case format::GuidedTexel::index8:
            return draw_in_mode<GuidedIndex8, Mean>(field, camera, surface, mode, background);
        case format::GuidedTexel::vq8:
            return draw_in_mode<GuidedVq8, Mean>(field, camera, surface, mode, background);
        case format::GuidedTexel::none:
            break;
    }
    if constexpr (Mean::kHasMean)
        return draw_in_mode<GuidedIndex4, Mean>(field, camera, surface, GuidedMode::mean, background);
    throw std::logic_error("open_guided let a field without colours pass");
}

template <class Surface>
Picture draw_stripes(const GuidedField& field, const Camera& camera, Surface& surface, GuidedMode mode,
                     const Rgb8& background)
{
    if (field.mean.resolution == 0) return draw_with_mean<NoMean>(field, camera, surface, mode, background);
    if (field.mean.format == format::MeanFormat::rgb565)
        return draw_with_mean<MeanRgb565>(field, camera, surface, mode, background);
    return draw_with_mean<MeanPalette8>(field, camera, surface, mode, background);
}

}  // namespace lumi::tools
