// SPDX-License-Identifier: MIT
#include "lumi/tools/draw.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <utility>

#include "lumi/span.h"
#include "lumi/tools/interrupt.h"

namespace lumi::tools
{

namespace
{

constexpr int kStripeRows = 16;  // what firmware with a few kilobytes to spare draws at once

template <class Pixel>
void copy_stripe(const Stripe& stripe, Picture& picture)
{
    for (int y = 0; y < stripe.height_px; ++y)
        for (int x = 0; x < stripe.width_px; ++x) {
            const uint8_t* bytes =
                stripe.pixels + static_cast<size_t>(y) * stripe.stride_bytes + static_cast<size_t>(x) * Pixel::kBytes;
            const Rgb8 colour = Pixel::load(bytes);  // what a display shows
            uint8_t* target = picture.pixel(x, stripe.y_px + y);
            target[0] = colour.r;
            target[1] = colour.g;
            target[2] = colour.b;
        }
}

template <class Reconstruction, class Texel, class Pixel>
Picture draw_as(const Field& field, const Camera& camera, const DrawSettings& settings)
{
    Picture picture(camera.width_px, camera.height_px);
    const uint32_t stride = static_cast<uint32_t>(camera.width_px) * Pixel::kBytes;
    std::vector<uint8_t> buffer(static_cast<size_t>(stride) * kStripeRows);
    for (int y = 0; y < camera.height_px; y += kStripeRows) {
        leave_if_interrupted();
        const int rows = std::min(kStripeRows, camera.height_px - y);
        const Stripe stripe = {buffer.data(), 0, y, camera.width_px, rows, stride};
        const RenderError error = render_spans<Reconstruction, Texel, Pixel>(
            field, camera, OverColour{settings.background}, stripe, settings.span_px);
        assert(error == RenderError::none);  // draw() chose the texel policy by the field's own format
        static_cast<void>(error);
        copy_stripe<Pixel>(stripe, picture);
    }
    return picture;
}

// The three choices, one after another: each calls `next` with a value of the policy's type.
template <class Next>
Picture with_texel(format::TexelFormat format, const Next& next)
{
    switch (format) {
        case format::TexelFormat::rgb888:
            return next(TexelRgb888());
        case format::TexelFormat::rgb565:
            return next(TexelRgb565());
        case format::TexelFormat::palette8:
            return next(TexelPalette8());
        case format::TexelFormat::luma8:
            return next(TexelLuma8());
    }
    throw std::logic_error("open_field let an unknown texel format pass");
}

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
        case Mode::voronoi:
            return next(NearestVoronoi());
        case Mode::dither:
            return next(Dither());
        case Mode::linear:
            return next(Linear());
        case Mode::paper:
            return with_neighbours(settings.neighbours, next, std::make_integer_sequence<uint32_t, kMaxNeighbours>());
    }
    throw std::logic_error("unknown mode");
}

template <class Next>
Picture with_pixel(DisplayFormat display, const Next& next)
{
    switch (display) {
        case DisplayFormat::rgb888:
            return next(PixelRgb888());
        case DisplayFormat::rgb565:
            return next(PixelRgb565());
        case DisplayFormat::grey8:
            return next(PixelGrey8());
    }
    throw std::logic_error("unknown display format");
}

}  // namespace

Picture draw(const Field& field, const Camera& camera, const DrawSettings& settings)
{
    assert(settings.neighbours >= 1 && settings.neighbours <= kMaxNeighbours);
    return with_texel(field.texel_format, [&](auto texel) {
        return with_reconstruction(settings, [&](auto reconstruction) {
            return with_pixel(settings.display, [&](auto pixel) {
                return draw_as<decltype(reconstruction), decltype(texel), decltype(pixel)>(field, camera, settings);
            });
        });
    });
}

}  // namespace lumi::tools
