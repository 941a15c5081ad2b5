// SPDX-License-Identifier: MIT
// Chord fields by one format of texels, with every reconstruction and display that the tool can ask for. Each format is
// instantiated in a file of its own, so that they compile side by side.
#pragma once

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <utility>
#include <vector>

#include "draw/display.h"
#include "lumi/chord/render_spans.h"
#include "terminal/failure.h"

namespace lumi::tools
{

inline constexpr int kSpanStripeHeight = 16;  // firmware with a few kilobytes to spare draws so many at once

// The paper's kernel is drawn exactly, whatever the settings say.
template <class Reconstruction>
inline constexpr bool kHasSpans = true;
template <uint32_t kNeighbours>
inline constexpr bool kHasSpans<Paper<kNeighbours>> = false;

template <class Reconstruction, class Texel, class Pixel>
RenderError draw_stripe(const Field& field, const Camera& camera, const DrawSettings& settings, const Stripe& stripe)
{
    const OverColour background = {settings.background};
    if constexpr (kHasSpans<Reconstruction>)
        if (settings.span_px >= 2 && fits_spans(field))
            return render_spans<Reconstruction, Texel, Pixel>(field, camera, background, stripe, settings.span_px);
    return render<Reconstruction, Texel, Pixel>(field, camera, background, stripe);
}

template <class Reconstruction, class Texel, class Pixel>
Picture draw_as(const Field& field, const Camera& camera, const DrawSettings& settings)
{
    Picture picture(camera.width_px(), camera.height_px());
    const uint32_t stride = static_cast<uint32_t>(camera.width_px()) * Pixel::kBytes;
    std::vector<uint8_t> buffer(static_cast<size_t>(stride) * kSpanStripeHeight);
    for (int y = 0; y < camera.height_px(); y += kSpanStripeHeight) {
        leave_if_interrupted();
        const int height = std::min(kSpanStripeHeight, camera.height_px() - y);
        const Stripe stripe = {buffer.data(), 0, y, camera.width_px(), height, stride};
        const RenderError error = draw_stripe<Reconstruction, Texel, Pixel>(field, camera, settings, stripe);
        assert(error == RenderError::none);  // draw() chose the texel policy by the field's own format
        static_cast<void>(error);
        copy_stripe<Pixel>(stripe, picture);
    }
    return picture;
}

// The choices, one after another: each calls `next` with a value of the policy's type.
template <class Next, uint32_t... kNeighbours>
Picture with_neighbours(uint32_t count, const Next& next, std::integer_sequence<uint32_t, kNeighbours...>)
{
    Picture picture;
    ((count == kNeighbours + 1 ? void(picture = next(Paper<kNeighbours + 1>())) : void()), ...);
    return picture;
}

template <class Next>
Picture with_reconstruction(const DrawSettings& settings, const Next& next)
{
    switch (settings.mode) {
        case Mode::nearest:
            return next(Nearest());
        case Mode::linear:
            return next(Linear());
        case Mode::paper:
            return with_neighbours(settings.neighbours, next,
                                   std::make_integer_sequence<uint32_t, detail::kMaxNeighbours>());
    }
    throw std::logic_error("unknown mode");
}

// Draws all stripes of a field whose texels are of the format Texel.
template <class Texel>
Picture draw_texels(const Field& field, const Camera& camera, const DrawSettings& settings)
{
    return with_reconstruction(
        settings,
        [&](auto reconstruction) {
            return with_pixel(
                settings.display,
                [&](auto pixel) {
                    return draw_as<decltype(reconstruction), Texel, decltype(pixel)>(field, camera, settings);
                });
        });
}

}  // namespace lumi::tools
