// SPDX-License-Identifier: MIT
// Draws fields of both kinds as the numbers of a scene say, by every renderer, into memory of its very size: what the
// fuzz targets share.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>

#include "lumi/chord/render_spans.h"
#include "lumi/surface/parts.h"
#include "lumi/surface/render.h"
#include "lumi/surface/states.h"

namespace lumi::fuzz
{

// How many inputs got as far as a picture; said at the end.
struct Drawn {
    uint64_t chords = 0, surfaces = 0;
    ~Drawn()
    {
        std::fprintf(stderr, "drawn: %llu chord fields, %llu surface fields\n", static_cast<unsigned long long>(chords),
                     static_cast<unsigned long long>(surfaces));
    }
};
inline Drawn drawn;

struct Scene {
    Pose pose;
    Image image;
    int32_t x, y, width, height;
    uint32_t choice;
};

// A stripe in memory of its very size.
struct Canvas {
    explicit Canvas(const Scene& s, uint32_t pixel_bytes)
        : stride(static_cast<uint32_t>(s.width) * pixel_bytes),
          pixels(new uint8_t[stride * static_cast<size_t>(s.height)]())
    {
        stripe = {pixels.get(), s.x, s.y, s.width, s.height, stride};
    }

    uint32_t stride;
    std::unique_ptr<uint8_t[]> pixels;
    Stripe stripe{};
};

template <class Texel>
void draw_chord(const Field& field, const Camera& camera, const Scene& s)
{
    Canvas canvas(s, PixelRgb888::kBytes);
    const OverColour background{{1, 2, 3}};
    const auto exactly = [&](auto reconstruction) {
        return render<decltype(reconstruction), Texel, PixelRgb888>(field, camera, background, canvas.stripe);
    };
    const auto by_spans = [&](auto reconstruction) {
        return render_spans<decltype(reconstruction), Texel, PixelRgb888>(field, camera, background, canvas.stripe,
                                                                          1 << (s.choice >> 4 & 7));
    };
    const uint32_t kind = s.choice & 7;
    if (kind == 1)
        static_cast<void>(exactly(Paper<5>()));
    else if ((s.choice & 8) != 0)
        static_cast<void>(kind == 0 ? exactly(Nearest()) : exactly(Linear()));
    else
        static_cast<void>(kind == 0 ? by_spans(Nearest()) : by_spans(Linear()));
}

inline void draw_chord(const Field& field, const Scene& s)
{
    Camera camera;
    if (make_camera(s.pose, s.image, camera) != CameraError::none) return;
    ++drawn.chords;
    detail::with_texel(field.texel_format, [&](auto texel) { draw_chord<decltype(texel)>(field, camera, s); });
}

inline void draw_surface(SurfaceField field, const Scene& s)
{
    SurfaceCamera camera;
    if (make_surface_camera(s.pose, s.image, camera) != CameraError::none) return;
    ++drawn.surfaces;
    const auto mode = static_cast<SurfaceMode>(s.choice % 3);
    const uint32_t band_log2 = s.choice >> 4 & 7;
    const std::unique_ptr<SurfaceVertex[]> vertices(new SurfaceVertex[field.vertex_count]);
    const std::unique_ptr<uint16_t[]> links(new uint16_t[surface_links(field.patch_count)]);
    const std::unique_ptr<uint16_t[]> bands(new uint16_t[surface_bands(s.image.height_px, band_log2)]);
    const std::unique_ptr<uint32_t[]> features(new uint32_t[feature_words(field)]());
    SurfaceFrame frame;
    const SurfaceMemory memory = {vertices.get(), links.get(), bands.get(), band_log2, features.get()};
    prepare_surface<PixelRgb565, SurfaceMode::two_by_two, SurfaceFeatures::all>(field, camera, mode, memory, frame);
    for (uint32_t part = 0; part < field.part_count; ++part) {
        const uint32_t value = s.choice * (2 * part + 1) << 8;
        if (!turn_part(field, memory, part, value)) slide_part(field, memory, part, static_cast<int32_t>(value));
    }
    for (uint32_t state = 0; state < field.state_count; ++state) {
        const auto weight = [&](uint32_t shift) { return static_cast<uint16_t>(s.choice >> shift); };
        set_state(field, memory, state, {weight(state), weight(8), weight(3 * state)});
    }
    if (field.part_count + field.state_count != 0)
        prepare_surface<PixelRgb565, SurfaceMode::two_by_two, SurfaceFeatures::all>(field, camera, mode, memory, frame);
    Canvas canvas(s, PixelRgb565::kBytes);
    const std::unique_ptr<uint32_t[]> samples(new uint32_t[(surface_stripe_bytes(s.width, s.height, mode) + 3) / 4]);
    render_surface<PixelRgb565, SurfaceMode::two_by_two, SurfaceFeatures::all>(frame, OverColour{{1, 2, 3}},
                                                                               canvas.stripe, samples.get());
}

// Draws the file's field, of either kind, if it is one.
inline void draw_field(const uint8_t* bytes, size_t size, const Scene& scene)
{
    Field chord;
    if (open_field(bytes, size, chord) == FieldError::none) draw_chord(chord, scene);
    SurfaceField surface;
    if (open_surface<SurfaceFeatures::all>(bytes, size, surface) == FieldError::none) draw_surface(surface, scene);
}

}  // namespace lumi::fuzz
