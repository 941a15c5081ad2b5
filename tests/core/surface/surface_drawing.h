// SPDX-License-Identifier: MIT
// Draws pictures of surface fields for tests, in stripes of any size.
#pragma once

#include <algorithm>
#include <vector>

#include "field_bytes.h"
#include "lumi/surface/render.h"
#include "views.h"

namespace lumi::test
{

inline constexpr Rgb8 kSurfaceBackground = {1, 2, 3};

// A field with the bytes that it is read from.
template <SurfaceFeatures kFeatures>
class Opened
{
public:
    explicit Opened(Bytes bytes) : bytes_(std::move(bytes))
    {
        error_ = open_surface<kFeatures>(bytes_.data(), bytes_.size(), field_);
    }
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;

    FieldError error() const { return error_; }
    const SurfaceField& field() const { return field_; }
    const Bytes& bytes() const { return bytes_; }

private:
    Bytes bytes_;
    SurfaceField field_;
    FieldError error_;
};
using OpenedSurface = Opened<SurfaceFeatures::view_tables>;
using OpenedGlass = Opened<SurfaceFeatures::all>;

// A frame with its memory.
class SurfaceScreen
{
public:
    SurfaceScreen(const SurfaceField& field, const Pose& pose, const Image& image, SurfaceMode mode,
                  uint32_t band_log2 = 3)
        : image_(image),
          mode_(mode),
          vertices_(field.vertex_count),
          links_(surface_links(field.patch_count)),
          bands_(surface_bands(image.height_px, band_log2))
    {
        SurfaceCamera camera;
        error_ = make_surface_camera(pose, image, camera);
        if (error_ == CameraError::none) {
            prepare_surface<PixelRgb888>(field, camera, mode,
                                         {vertices_.data(), links_.data(), bands_.data(), band_log2}, frame_);
        }
    }
    SurfaceScreen(const SurfaceScreen&) = delete;
    SurfaceScreen& operator=(const SurfaceScreen&) = delete;

    CameraError error() const { return error_; }
    const SurfaceFrame& frame() const { return frame_; }

    // Into exactly as much memory for samples as the header says.
    void draw(const Stripe& stripe)
    {
        const uint32_t bytes = surface_stripe_bytes(stripe.width_px, stripe.height_px, mode_);
        std::vector<uint32_t> samples((bytes + 3) / 4);
        render_surface<PixelRgb888>(frame_, OverColour{kSurfaceBackground}, stripe, samples.data());
    }

    // The whole picture in rectangles of at most so many pixels.
    Bytes picture(int32_t width, int32_t height)
    {
        const uint32_t stride = 3 * static_cast<uint32_t>(image_.width_px);
        Bytes pixels(stride * static_cast<size_t>(image_.height_px), 0xA5);
        for (int32_t y = 0; y < image_.height_px; y += height) {
            for (int32_t x = 0; x < image_.width_px; x += width) {
                uint8_t* const at = pixels.data() + static_cast<uint32_t>(y) * stride + 3 * static_cast<uint32_t>(x);
                draw({at, x, y, std::min(width, image_.width_px - x), std::min(height, image_.height_px - y), stride});
            }
        }
        return pixels;
    }

private:
    Image image_;
    SurfaceMode mode_;
    std::vector<SurfaceVertex> vertices_;
    std::vector<uint16_t> links_, bands_;
    SurfaceFrame frame_;
    CameraError error_;
};

inline const SurfaceMode kSurfaceModes[] = {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two};

}  // namespace lumi::test
