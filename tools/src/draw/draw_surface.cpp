// SPDX-License-Identifier: MIT
#include "draw/draw_surface.h"

#include <algorithm>
#include <vector>

#include "draw/display.h"
#include "lumi/surface/render.h"
#include "terminal/failure.h"
#include "terminal/interrupt.h"

namespace lumi::tools
{

namespace
{

constexpr uint32_t kBandLog2 = 4;  // rows of a stripe: what firmware with some kilobytes to spare draws at once
constexpr int kStripeHeight = 1 << kBandLog2;

SurfaceCamera camera_of(const Eye& eye)
{
    SurfaceCamera camera;
    if (const CameraError error = make_surface_camera(eye.pose, eye.image, camera); error != CameraError::none)
        throw UsageError(std::string("the camera cannot be used: ") + describe(error));
    return camera;
}

// What a frame borrows from its caller.
struct FrameMemory {
    std::vector<SurfaceVertex> vertices;
    std::vector<uint16_t> links, bands;

    FrameMemory(const SurfaceField& field, int32_t height_px)
        : vertices(field.vertex_count),
          links(surface_links(field.patch_count)),
          bands(surface_bands(height_px, kBandLog2))
    {
    }
    SurfaceMemory borrowed() { return {vertices.data(), links.data(), bands.data(), kBandLog2}; }
};

template <class Pixel>
Picture draw_as(const SurfaceField& field, const Eye& eye, const SurfaceDrawSettings& settings)
{
    const int32_t width = eye.image.width_px, height = eye.image.height_px;
    FrameMemory memory(field, height);
    SurfaceFrame frame;
    prepare_surface<Pixel>(field, camera_of(eye), settings.mode, memory.borrowed(), frame);
    Picture picture(width, height);
    const uint32_t stride = static_cast<uint32_t>(width) * Pixel::kBytes;
    std::vector<uint8_t> buffer(static_cast<size_t>(stride) * kStripeHeight);
    std::vector<uint32_t> samples(surface_stripe_bytes(width, kStripeHeight, settings.mode) / sizeof(uint32_t) + 1);
    for (int y = 0; y < height; y += kStripeHeight) {
        leave_if_interrupted();
        const Stripe stripe = {buffer.data(), 0, y, width, std::min(kStripeHeight, height - y), stride};
        render_surface<Pixel>(frame, OverColour{settings.background}, stripe, samples.data());
        copy_stripe<Pixel>(stripe, picture);
    }
    return picture;
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
    Plane<uint16_t> depths(width, height);
    std::vector<detail::PackedColour> colours(depths.values.size());
    detail::rasterize(frame, {0, 0, width, height}, depths.values.data(), colours.data());
    return depths;
}

}  // namespace lumi::tools
