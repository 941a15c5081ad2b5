// SPDX-License-Identifier: MIT
#include "draw/draw_surface.h"

#include <algorithm>
#include <vector>

#include "draw/display.h"
#include "lumi/surface/parts.h"
#include "lumi/surface/render.h"
#include "lumi/surface/states.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

constexpr int kStripeHeight = 16;  // firmware with some kilobytes to spare draws so many at once
constexpr uint32_t kBandLog2 = surface_band_log2(kStripeHeight);

SurfaceCamera camera_of(const Eye& eye)
{
    SurfaceCamera camera;
    if (const CameraError error = make_surface_camera(eye.pose, eye.image, camera); error != CameraError::none)
        throw UsageError(std::string("the camera cannot be used: ") + describe(error));
    return camera;
}

// A frame borrows this from its caller.
struct FrameMemory {
    std::vector<SurfaceVertex> vertices;
    std::vector<uint16_t> links, bands;
    std::vector<uint32_t> features;

    FrameMemory(const SurfaceField& field, int32_t height_px)
        : vertices(field.vertex_count),
          links(surface_links(field.patch_count)),
          bands(surface_bands(height_px, kBandLog2)),
          features(feature_words(field))
    {
    }
    SurfaceMemory borrowed() { return {vertices.data(), links.data(), bands.data(), kBandLog2, features.data()}; }
};

template <class Pixel>
Picture draw_as(SurfaceField field, const Eye& eye, const SurfaceDrawSettings& settings)
{
    const int32_t width = eye.image.width_px, height = eye.image.height_px;
    FrameMemory memory(field, height);
    if (!settings.states.empty()) reset_states(field, memory.borrowed());
    for (const StateValue& s : settings.states) set_state(field, memory.borrowed(), s.state, s.weight);
    for (const PartValue& p : settings.parts)
        if (!turn_part(field, memory.borrowed(), p.part, p.value))
            slide_part(field, memory.borrowed(), p.part, static_cast<int32_t>(p.value));
    SurfaceFrame frame;
    prepare_surface<Pixel, SurfaceMode::two_by_two, SurfaceFeatures::all>(field, camera_of(eye), settings.mode,
                                                                          memory.borrowed(), frame);
    Picture picture(width, height);
    const uint32_t stride = static_cast<uint32_t>(width) * Pixel::kBytes;
    std::vector<uint8_t> buffer(static_cast<size_t>(stride) * kStripeHeight);
    std::vector<uint32_t> samples(surface_stripe_bytes(width, kStripeHeight, settings.mode) / sizeof(uint32_t) + 1);
    for (int y = 0; y < height; y += kStripeHeight) {
        leave_if_interrupted();
        const Stripe stripe = {buffer.data(), 0, y, width, std::min(kStripeHeight, height - y), stride};
        render_surface<Pixel, SurfaceMode::two_by_two, SurfaceFeatures::all>(frame, OverColour{settings.background},
                                                                             stripe, samples.data());
        copy_stripe<Pixel>(stripe, picture);
    }
    return picture;
}

// Reads the samples that render_surface left.
Plane<uint16_t> depths_of(const SurfaceFrame& frame, const Stripe& stripe, void* samples)
{
    Plane<uint16_t> depths(stripe.width_px, stripe.height_px);
    const Stripe covered = detail::covered_part(frame, stripe, PixelRgb888::kBytes);
    if (covered.width_px == 0) return depths;
    const detail::Target target = detail::target_of(frame, covered, stripe.x_px, frame.samples_are_pixels, samples);
    for (int32_t y = 0; y < target.height; ++y)
        std::copy_n(target.depths(y), target.width,
                    depths.values.begin() + (target.y + y) * stripe.width_px + target.x);
    return depths;
}

}  // namespace

const char* name_of(SurfaceMode mode)
{
    switch (mode) {
        case SurfaceMode::one_sample:
            return "one-sample";
        case SurfaceMode::antialiased:
            return "antialiased";
        case SurfaceMode::two_by_two:
            return "2x2";
    }
    return "unknown";
}

Picture draw_surface(const SurfaceField& field, const Eye& eye, const SurfaceDrawSettings& settings)
{
    return with_pixel(
        settings.display, [&](auto pixel) { return draw_as<decltype(pixel)>(field, eye, settings); });
}

Plane<uint16_t> surface_depths(const SurfaceField& field, const Eye& eye)
{
    const int32_t width = eye.image.width_px, height = eye.image.height_px;
    FrameMemory memory(field, height);
    SurfaceFrame frame;
    prepare_surface<PixelRgb888>(field, camera_of(eye), SurfaceMode::one_sample, memory.borrowed(), frame);
    std::vector<uint32_t> samples(surface_stripe_bytes(width, height, SurfaceMode::one_sample) / sizeof(uint32_t) + 1);
    std::vector<uint8_t> pixels(static_cast<size_t>(width) * static_cast<size_t>(height) * PixelRgb888::kBytes);
    const Stripe stripe = {pixels.data(), 0, 0, width, height, static_cast<uint32_t>(width) * PixelRgb888::kBytes};
    render_surface<PixelRgb888>(frame, OverBlack{}, stripe, samples.data());
    return depths_of(frame, stripe, samples.data());
}

}  // namespace lumi::tools
