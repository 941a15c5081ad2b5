// SPDX-License-Identifier: MIT
// The frames of frame_list.h of one view and one texel format.
#pragma once

#include "listed_frame.h"
#include "lumi/chord/render.h"
#include "lumi/chord/render_spans.h"
#include "lumi/detail/crc32.h"

namespace lumi::firmware
{

inline constexpr int32_t kStripeHeight = 10;  // does not divide the height: the last stripe is shorter
inline constexpr uint32_t kMaxPixelBytes = 3;
inline constexpr int32_t kSpanPx = 8;
inline constexpr Rgb8 kBackground = {40, 96, 168};

#ifdef LUMI_EVERY_FRAME
inline constexpr bool kEveryFrame = true;
#else
inline constexpr bool kEveryFrame = false;
#endif

// These are the two renderers, as policies: every pixel exact, or spans between exact hits.
template <class Reconstruction>
struct Exact {
    template <class Texel, class Pixel, class Background>
    static RenderError draw(const Field& field, const Camera& camera, const Background& background,
                            const Stripe& stripe)
    {
        return render<Reconstruction, Texel, Pixel>(field, camera, background, stripe);
    }
};

template <class Reconstruction>
struct Spans {
    template <class Texel, class Pixel, class Background>
    static RenderError draw(const Field& field, const Camera& camera, const Background& background,
                            const Stripe& stripe)
    {
        return render_spans<Reconstruction, Texel, Pixel>(field, camera, background, stripe, kSpanPx);
    }
};

template <class Policy>
struct Named {
    using Type = Policy;
    const char* name;
};

inline constexpr Named<Exact<Nearest>> kNearest = {"nearest"};
inline constexpr Named<Exact<Linear>> kLinear = {"linear"};
inline constexpr Named<Exact<Paper<5>>> kPaper5 = {"paper5"};
inline constexpr Named<Spans<Nearest>> kNearestSpans = {"nearest-spans"};
inline constexpr Named<Spans<Linear>> kLinearSpans = {"linear-spans"};

inline constexpr Named<PixelRgb565> kPixelRgb565 = {"rgb565"};
inline constexpr Named<PixelRgb565Swapped> kPixelRgb565Swapped = {"rgb565-swapped"};
inline constexpr Named<PixelRgb888> kPixelRgb888 = {"rgb888"};
inline constexpr Named<PixelGrey8> kPixelGrey8 = {"grey8"};

inline uint8_t stripe_pixels[kWidth * kStripeHeight * kMaxPixelBytes];

// Draws over black, on some cores.
template <class Pixel>
inline constexpr bool kHasLoopsOfItsOwn = false;
template <>
inline constexpr bool kHasLoopsOfItsOwn<PixelRgb565> = true;

// Draws a stripe over the background, then over itself, then, as RGB565, over black, where cores have loops of their
// own; extends the CRC after each.
template <class Renderer, class Texel, class Pixel>
RenderError draw_stripe(const Frame& frame, const Stripe& stripe, uint32_t& crc)
{
    const size_t bytes = static_cast<size_t>(stripe.height_px) * stripe.stride_bytes;
    const RenderError error =
        Renderer::template draw<Texel, Pixel>(frame.field, frame.camera, OverColour{kBackground}, stripe);
    if (error != RenderError::none) return error;
    crc = detail::crc32(crc, stripe.pixels, bytes);
    RenderError again = Renderer::template draw<Texel, Pixel>(frame.field, frame.camera, OverStripe{}, stripe);
    crc = detail::crc32(crc, stripe.pixels, bytes);
    if constexpr (kHasLoopsOfItsOwn<Pixel>) {
        again = Renderer::template draw<Texel, Pixel>(frame.field, frame.camera, OverBlack{}, stripe);
        crc = detail::crc32(crc, stripe.pixels, bytes);
    }
    return again;
}

template <class Renderer, class Texel, class Pixel>
RenderError frame_crc(const Frame& frame, uint32_t& crc)
{
    constexpr uint32_t kStride = kWidth * Pixel::kBytes;
    static_assert(Pixel::kBytes <= kMaxPixelBytes, "stripe_pixels must hold a stripe");
    for (int32_t y = 0; y < kHeight; y += kStripeHeight) {
        const int32_t height = kHeight - y < kStripeHeight ? kHeight - y : kStripeHeight;
        const RenderError error =
            draw_stripe<Renderer, Texel, Pixel>(frame, {stripe_pixels, 0, y, kWidth, height, kStride}, crc);
        if (error != RenderError::none) return error;
    }
    return RenderError::none;
}

template <class Texel, class Renderer, class Pixel>
bool write_line(const Frame& frame, Renderer renderer, Pixel pixel)
{
    uint32_t crc = 0;
    if (frame_crc<typename Renderer::Type, Texel, typename Pixel::Type>(frame, crc) != RenderError::none)
        return refuse(frame.write, "the field holds other texels than its header says");
    TextLine line;
    line.text(frame.view.name).text(" ").text(renderer.name).text(" ").text(frame.texel).text(" ");
    frame.write(line.text(pixel.name).text(" ").hex32(crc).text("\n").c_str());
    return true;
}

template <class Texel, class Renderer>
bool for_each_pixel_format(const Frame& frame, Renderer renderer)
{
    return write_line<Texel>(frame, renderer, kPixelRgb565) &&
           write_line<Texel>(frame, renderer, kPixelRgb565Swapped) &&
           write_line<Texel>(frame, renderer, kPixelRgb888) && write_line<Texel>(frame, renderer, kPixelGrey8);
}

// Pixels are stored by the same code whatever the reconstruction: one of them shows every format.
template <class Texel, class Renderer>
bool for_one_pixel_format(const Frame& frame, Renderer renderer)
{
    if constexpr (kEveryFrame)
        return for_each_pixel_format<Texel>(frame, renderer);
    else
        return write_line<Texel>(frame, renderer, kPixelRgb565);
}

// Writes all lines of one view and one texel format.
template <class Texel>
bool write_texel_frames(const Frame& frame)
{
    return for_one_pixel_format<Texel>(frame, kNearest) && for_each_pixel_format<Texel>(frame, kLinear) &&
           for_one_pixel_format<Texel>(frame, kPaper5) && for_one_pixel_format<Texel>(frame, kNearestSpans) &&
           for_each_pixel_format<Texel>(frame, kLinearSpans);
}

}  // namespace lumi::firmware
