// SPDX-License-Identifier: MIT
// Chord fields that are open, and frames of them, drawn exactly or by spans.
#pragma once

#include <catch2/catch.hpp>
#include <utility>

#include "field_bytes.h"
#include "lumi/chord/render_spans.h"
#include "views.h"

namespace lumi::test
{

struct OpenField {
    const Bytes bytes;
    Field field;

    explicit OpenField(Bytes file) : bytes(std::move(file))
    {
        REQUIRE(open_field(bytes.data(), bytes.size(), field) == FieldError::none);
    }
    // Each byte of its texels is texel(row, byte in row).
    template <class Texel>
    OpenField(const TestLayout& layout, const Texel& texel)
        : OpenField(file_of({layout_section(layout), texel_section(layout, texel)}))
    {
    }
};

inline Camera camera_of(const Pose& pose, const Image& image)
{
    Camera camera;
    REQUIRE(make_camera(pose, image, camera) == CameraError::none);
    return camera;
}

inline Camera camera_of(const View& view)
{
    return camera_of(view.pose, view.image);
}

// span_px = 0 draws exactly.
template <class Reconstruction, class Texel, class Pixel, class Background>
RenderError draw_chord(const Field& field, const Camera& camera, const Background& background, const Stripe& stripe,
                       int32_t span_px)
{
    if (span_px == 0) return render<Reconstruction, Texel, Pixel>(field, camera, background, stripe);
    return render_spans<Reconstruction, Texel, Pixel>(field, camera, background, stripe, span_px);
}

// The pixels of a window, which hold `held` before.
template <class Reconstruction, class Texel, class Pixel, class Background>
Bytes drawn_window(const Field& field, const Camera& camera, const Background& background, int32_t span_px, int32_t x,
                   int32_t y, int32_t width, int32_t height, uint8_t held = 0)
{
    const uint32_t stride = static_cast<uint32_t>(width) * Pixel::kBytes;
    Bytes pixels(stride * static_cast<size_t>(height), held);
    REQUIRE(draw_chord<Reconstruction, Texel, Pixel>(
                field, camera, background, {pixels.data(), x, y, width, height, stride}, span_px) == RenderError::none);
    return pixels;
}

template <class Reconstruction, class Texel, class Pixel, class Background>
Bytes drawn_frame(const Field& field, const Camera& camera, const Background& background, int32_t span_px,
                  uint8_t held = 0)
{
    return drawn_window<Reconstruction, Texel, Pixel>(field, camera, background, span_px, 0, 0, camera.width_px(),
                                                      camera.height_px(), held);
}

}  // namespace lumi::test
