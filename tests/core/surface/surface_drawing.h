// SPDX-License-Identifier: MIT
// Draws pictures of surface fields for tests, in rectangles of any size.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "field_bytes.h"
#include "lumi/surface/render.h"
#include "views.h"

namespace lumi::test
{

inline constexpr SurfaceFeatures kAll = SurfaceFeatures::all;
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

// A frame with memory of its very size. Vertices and links hold what an older frame may have left.
struct PreparedFrame {
    PreparedFrame(const SurfaceField& field, int32_t height_px, uint32_t band_log2 = 3)
        : vertices(field.vertex_count),
          links(surface_links(field.patch_count), 0x5A5A),
          bands(surface_bands(height_px, band_log2), 0x5A5A),
          features(feature_words(field)),
          memory{vertices.data(), links.data(), bands.data(), band_log2, features.data()}
    {
    }
    PreparedFrame(const PreparedFrame&) = delete;
    PreparedFrame& operator=(const PreparedFrame&) = delete;

    template <class Pixel, SurfaceFeatures kFeatures = kAll>
    void prepare(const SurfaceField& field, const View& view, SurfaceMode mode)
    {
        SurfaceCamera camera;
        REQUIRE(make_surface_camera(view.pose, view.image, camera) == CameraError::none);
        prepare_surface<Pixel, SurfaceMode::two_by_two, kFeatures>(field, camera, mode, memory, frame);
    }

    std::vector<SurfaceVertex> vertices;
    std::vector<uint16_t> links, bands;
    std::vector<uint32_t> features;
    SurfaceMemory memory;
    SurfaceFrame frame{};
};

// Draws a stripe, and returns its samples: exactly as much memory as the header says, which held an older stripe's.
template <class Pixel, SurfaceFeatures kFeatures = kAll, class Background>
std::vector<uint32_t> draw_stripe(const SurfaceFrame& frame, const Background& background, const Stripe& stripe)
{
    const uint32_t bytes = surface_stripe_bytes<Pixel>(stripe.width_px, stripe.height_px, frame.mode);
    std::vector<uint32_t> samples((bytes + 3) / 4, 0x5A5A5A5A);
    render_surface<Pixel, SurfaceMode::two_by_two, kFeatures>(frame, background, stripe, samples.data());
    return samples;
}

// The largest rectangles that a picture is drawn in.
struct Area {
    int32_t width = kMaxImageSide, height = kMaxImageSide;
    bool is_odd = false;  // whether rows of pixels of 16 bits begin in the middle of a word
};

// A picture, over a pattern, and its coverage where that is kept.
template <class Pixel>
struct Drawn {
    int32_t width, height;
    bool is_odd;
    std::vector<uint32_t> words = std::vector<uint32_t>((bytes() + 3) / 4 + 1);
    Bytes coverage = Bytes(static_cast<size_t>(width * height));

    size_t bytes() const { return static_cast<size_t>(width * height) * Pixel::kBytes; }
    uint8_t* first() { return reinterpret_cast<uint8_t*>(words.data()) + (is_odd && Pixel::kBytes == 2 ? 2 : 0); }
    uint8_t* pixel(int32_t x, int32_t y) { return first() + static_cast<size_t>(y * width + x) * Pixel::kBytes; }
    Rgb8 at(int32_t x, int32_t y) { return Pixel::load(pixel(x, y)); }
    Bytes pixels() { return Bytes(first(), first() + bytes()); }
};

template <class Pixel, SurfaceFeatures kFeatures = kAll, class Background = OverColour>
Drawn<Pixel> drawn(const SurfaceFrame& frame, const Background& background = {kSurfaceBackground},
                   const Area& area = {})
{
    Drawn<Pixel> result = {frame.width_px, frame.height_px, area.is_odd};
    const auto byte = [](int32_t v) { return static_cast<uint8_t>(v); };
    for (int32_t y = 0; y < frame.height_px; ++y)
        for (int32_t x = 0; x < frame.width_px; ++x)
            Pixel::store(result.pixel(x, y), {byte(y * frame.width_px + x), byte(y * 6), byte(x)});
    const uint32_t stride = static_cast<uint32_t>(frame.width_px) * Pixel::kBytes;
    for (int32_t y = 0; y < frame.height_px; y += area.height) {
        for (int32_t x = 0; x < frame.width_px; x += area.width) {
            Stripe stripe = {result.pixel(x, y),
                             x,
                             y,
                             std::min(area.width, frame.width_px - x),
                             std::min(area.height, frame.height_px - y),
                             stride};
            std::vector<uint32_t> samples = draw_stripe<Pixel, kFeatures>(frame, background, stripe);
            if constexpr (detail::kKeepsCoverage<Background>) {
                stripe.pixels = &result.coverage[static_cast<size_t>(y * frame.width_px + x)];
                stripe.stride_bytes = static_cast<uint32_t>(frame.width_px);
                render_coverage<kFeatures>(frame, stripe, samples.data());
            }
        }
    }
    return result;
}

template <class Pixel, SurfaceFeatures kFeatures = kAll, class Background = OverColour>
Drawn<Pixel> drawn(const SurfaceField& field, const View& view, SurfaceMode mode,
                   const Background& background = {kSurfaceBackground}, const Area& area = {}, uint32_t band_log2 = 3)
{
    PreparedFrame made(field, view.image.height_px, band_log2);
    made.prepare<Pixel, kFeatures>(field, view, mode);
    return drawn<Pixel, kFeatures>(made.frame, background, area);
}

// Draws as a program does that names view tables alone.
inline Bytes surface_picture(const SurfaceField& field, const View& view, SurfaceMode mode, const Area& area = {},
                             uint32_t band_log2 = 3)
{
    return drawn<PixelRgb888, SurfaceFeatures::view_tables>(field, view, mode, OverColour{kSurfaceBackground}, area,
                                                            band_log2)
        .pixels();
}

inline const SurfaceMode kSurfaceModes[] = {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two};

}  // namespace lumi::test
