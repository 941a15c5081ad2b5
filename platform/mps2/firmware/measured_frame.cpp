// SPDX-License-Identifier: MIT
#include "measured_frame.h"

#include "lumi/detail/crc32.h"
#include "lumi/mps2/meters.h"

namespace lumi::firmware
{
namespace
{

constexpr OverColour kBackground = {{24, 28, 36}};
constexpr uint32_t kStrideBytes = kFrameWidth * PixelRgb565::kBytes;
constexpr uint32_t kStripeBytes = kStrideBytes * kStripeHeight;

uint8_t stripe_pixels[kStripeBytes];

template <class Reconstruction, class Texel>
RenderError draw_stripe(const Field& field, const Camera& camera, const Stripe& stripe)
{
    return render<Reconstruction, Texel, PixelRgb565>(field, camera, kBackground, stripe);
}

template <class Reconstruction>
DrawStripe choose_texels(TexelFormat texels)
{
    return detail::with_texel(
        texels, [](auto texel) -> DrawStripe { return draw_stripe<Reconstruction, decltype(texel)>; });
}

uint32_t covered_pixels(const Camera& camera, const Stripe& stripe)
{
    uint32_t count = 0;
    for (int32_t y = stripe.y_px; y < stripe.y_px + stripe.height_px; ++y) {
        const detail::Extent span = detail::covered_extent(camera, y, stripe.x_px, stripe.x_px + stripe.width_px);
        count += static_cast<uint32_t>(span.end - span.begin);
    }
    return count;
}

// Draws one stripe and adds its cost to the report.
RenderError draw_measured_stripe(const Field& field, const Camera& camera, DrawStripe draw, const Stripe& stripe,
                                 FrameReport& report)
{
    mps2::StackMeter meter;
    meter.paint();
    const uint64_t begin = mps2::instructions();
    const RenderError error = draw(field, camera, stripe);
    report.instructions += mps2::instructions() - begin;
    const uint32_t stack_bytes = meter.high_water_bytes();
    report.stack_bytes = stack_bytes > report.stack_bytes ? stack_bytes : report.stack_bytes;
    return error;
}

}  // namespace

DrawStripe choose_renderer(Mode mode, TexelFormat texels)
{
    switch (mode) {
        case Mode::nearest:
            return choose_texels<Nearest>(texels);
        case Mode::linear:
            return choose_texels<Linear>(texels);
        case Mode::paper:
            return choose_texels<Paper<5>>(texels);
    }
    return nullptr;
}

FrameReport draw_measured_frame(const Field& field, const Camera& camera, DrawStripe draw, const StripeSink& sink)
{
    FrameReport report = {};
    for (int32_t y = 0; y < kFrameHeight; y += kStripeHeight) {
        const Stripe stripe = {stripe_pixels, 0, y, kFrameWidth, kStripeHeight, kStrideBytes};
        if (draw_measured_stripe(field, camera, draw, stripe, report) != RenderError::none) return report;
        report.crc = detail::crc32(report.crc, stripe_pixels, kStripeBytes);
        report.covered_px += covered_pixels(camera, stripe);
        if (!sink.flush(sink.context, stripe_pixels, kStripeBytes)) return report;
    }
    report.complete = true;
    return report;
}

}  // namespace lumi::firmware
