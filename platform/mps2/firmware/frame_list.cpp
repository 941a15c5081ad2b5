// SPDX-License-Identifier: MIT
#include "frame_list.h"

#include "lumi/crc32.h"
#include "lumi/render.h"
#include "lumi/span.h"
#include "text_line.h"
#include "views.h"

namespace lumi::firmware
{
namespace
{

constexpr int32_t kWidth = 48;
constexpr int32_t kHeight = 36;
constexpr int32_t kStripeRows = 10;  // does not divide the height: the last stripe is shorter
constexpr uint32_t kMaxPixelBytes = 3;
constexpr int32_t kSpanPx = 8;
constexpr Rgb8 kBackground = {40, 96, 168};

// The two renderers, as policies: every pixel exact, or spans between exact hits.
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

constexpr Named<Exact<Nearest>> kNearest = {"nearest"};
constexpr Named<Exact<Linear>> kLinear = {"linear"};
constexpr Named<Exact<Paper<5>>> kPaper5 = {"paper5"};
constexpr Named<Spans<Nearest>> kNearestSpans = {"nearest-spans"};
constexpr Named<Spans<NearestVoronoi>> kVoronoiSpans = {"voronoi-spans"};
constexpr Named<Spans<Dither>> kDitherSpans = {"dither-spans"};
constexpr Named<Spans<Linear>> kLinearSpans = {"linear-spans"};
constexpr Named<Spans<Paper<5>>> kPaper5Spans = {"paper5-spans"};

constexpr Named<TexelRgb888> kTexelRgb888 = {"rgb888"};
constexpr Named<TexelRgb565> kTexelRgb565 = {"rgb565"};
constexpr Named<TexelPalette8> kTexelPalette8 = {"palette8"};
constexpr Named<TexelLuma8> kTexelLuma8 = {"luma8"};

constexpr Named<PixelRgb565> kPixelRgb565 = {"rgb565"};
constexpr Named<PixelRgb565Swapped> kPixelRgb565Swapped = {"rgb565-swapped"};
constexpr Named<PixelRgb888> kPixelRgb888 = {"rgb888"};
constexpr Named<PixelGrey8> kPixelGrey8 = {"grey8"};

// What one line of the list is about; passed down while the policies are chosen one after the other.
struct Frame {
    const View& view;
    const Camera& camera;
    const Field& field;
    WriteText write;
};

uint8_t stripe_pixels[kWidth * kStripeRows * kMaxPixelBytes];

bool refuse(WriteText write, const char* why)
{
    TextLine line;
    write(line.text("error: ").text(why).text("\n").c_str());
    return false;
}

// Draws a stripe over the background, then over itself; extends the CRC after each.
template <class Renderer, class Texel, class Pixel>
RenderError draw_stripe(const Frame& frame, const Stripe& stripe, uint32_t& crc)
{
    const size_t bytes = static_cast<size_t>(stripe.height_px) * stripe.stride_bytes;
    const RenderError error =
        Renderer::template draw<Texel, Pixel>(frame.field, frame.camera, OverColour{kBackground}, stripe);
    if (error != RenderError::none) {
        return error;
    }
    crc = crc32(crc, stripe.pixels, bytes);
    const RenderError again = Renderer::template draw<Texel, Pixel>(frame.field, frame.camera, OverStripe{}, stripe);
    crc = crc32(crc, stripe.pixels, bytes);
    return again;
}

template <class Renderer, class Texel, class Pixel>
RenderError frame_crc(const Frame& frame, uint32_t& crc)
{
    constexpr uint32_t kStride = kWidth * Pixel::kBytes;
    static_assert(Pixel::kBytes <= kMaxPixelBytes, "stripe_pixels must hold a stripe");
    for (int32_t y = 0; y < kHeight; y += kStripeRows) {
        const int32_t rows = kHeight - y < kStripeRows ? kHeight - y : kStripeRows;
        const RenderError error =
            draw_stripe<Renderer, Texel, Pixel>(frame, {stripe_pixels, 0, y, kWidth, rows, kStride}, crc);
        if (error != RenderError::none) {
            return error;
        }
    }
    return RenderError::none;
}

template <class Renderer, class Texel, class Pixel>
bool write_line(const Frame& frame, Renderer renderer, Texel texel, Pixel pixel)
{
    uint32_t crc = 0;
    if (frame_crc<typename Renderer::Type, typename Texel::Type, typename Pixel::Type>(frame, crc) !=
        RenderError::none) {
        return refuse(frame.write, "the field holds other texels than its header says");
    }
    TextLine line;
    line.text(frame.view.name).text(" ").text(renderer.name).text(" ").text(texel.name).text(" ");
    frame.write(line.text(pixel.name).text(" ").hex32(crc).text("\n").c_str());
    return true;
}

template <class Renderer, class Texel>
bool for_each_pixel_format(const Frame& frame, Renderer renderer, Texel texel)
{
    return write_line(frame, renderer, texel, kPixelRgb565) &&
           write_line(frame, renderer, texel, kPixelRgb565Swapped) &&
           write_line(frame, renderer, texel, kPixelRgb888) && write_line(frame, renderer, texel, kPixelGrey8);
}

template <class Texel>
bool for_each_renderer(const Frame& frame, Texel texel)
{
    return for_each_pixel_format(frame, kNearest, texel) && for_each_pixel_format(frame, kLinear, texel) &&
           for_each_pixel_format(frame, kPaper5, texel) && for_each_pixel_format(frame, kNearestSpans, texel) &&
           for_each_pixel_format(frame, kVoronoiSpans, texel) && for_each_pixel_format(frame, kDitherSpans, texel) &&
           for_each_pixel_format(frame, kLinearSpans, texel) && for_each_pixel_format(frame, kPaper5Spans, texel);
}

bool for_the_field(const Frame& frame)
{
    switch (frame.field.texel_format) {
        case format::TexelFormat::rgb888:
            return for_each_renderer(frame, kTexelRgb888);
        case format::TexelFormat::rgb565:
            return for_each_renderer(frame, kTexelRgb565);
        case format::TexelFormat::palette8:
            return for_each_renderer(frame, kTexelPalette8);
        case format::TexelFormat::luma8:
            return for_each_renderer(frame, kTexelLuma8);
    }
    return false;
}

bool for_each_view(const Field& field, WriteText write)
{
    for (const View& view : kViews) {
        Camera camera;
        const CameraError error = make_camera(view.pose(), view.image(kWidth, kHeight), camera);
        if (error != CameraError::none) {
            return refuse(write, describe(error));
        }
        if (!for_the_field({view, camera, field, write})) {
            return false;
        }
    }
    return true;
}

}  // namespace

bool write_frame_crcs(const FieldBytes (&fields)[format::kTexelFormats], WriteText write)
{
    for (const FieldBytes& file : fields) {
        Field field;
        const FieldError error = open_field(file.bytes, file.size, field);
        if (error != FieldError::none) {
            return refuse(write, describe(error));
        }
        if (!for_each_view(field, write)) {
            return false;
        }
    }
    return true;
}

}  // namespace lumi::firmware
