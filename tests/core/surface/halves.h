// SPDX-License-Identifier: MIT
// Compares a frame that two halves prepare with that of one core: all that it holds, and its picture.
#pragma once

#include <catch2/catch.hpp>
#include <cstring>

#include "choices.h"
#include "extreme_frames.h"
#include "extreme_surfaces.h"
#include "lumi/surface/halves.h"
#include "surface_drawing.h"

namespace lumi::test
{

inline bool is_same(const detail::Extent& a, const detail::Extent& b)
{
    return a.begin == b.begin && a.end == b.end;
}

inline bool have_same_order(const SurfaceFrame& a, const SurfaceFrame& b)
{
    const uint32_t *const first = a.memory.features, count = a.see_through_triangles;
    return count == b.see_through_triangles && std::equal(first, first + count, b.memory.features);
}

// All that drawing reads.
inline bool are_same(const PreparedFrame& a, const PreparedFrame& b)
{
    const auto is_same_vertex = [](const SurfaceVertex& v, const SurfaceVertex& w) {
        return v.x == w.x && v.y == w.y && v.colour == w.colour;
    };
    const SurfaceFrame &f = a.frame, &g = b.frame;
    return std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), is_same_vertex) && a.links == b.links &&
           a.bands == b.bands && f.reach == g.reach && f.is_whole == g.is_whole && f.is_narrow == g.is_narrow &&
           f.margin == g.margin && is_same(f.columns, g.columns) && is_same(f.scanlines, g.scanlines) &&
           have_same_order(a.frame, b.frame) && std::equal(std::begin(f.palette), std::end(f.palette), g.palette);
}

inline Bytes picture(const SurfaceFrame& frame, const Edge& edge)
{
    const uint32_t stride = static_cast<uint32_t>(edge.width) * PixelRgb565::kBytes;
    Bytes pixels(stride * static_cast<size_t>(edge.height));
    draw_stripe<PixelRgb565>(frame, OverColour{kSurfaceBackground},
                             {pixels.data(), edge.x, edge.y, edge.width, edge.height, stride});
    return pixels;
}

// `run` runs both halves of a step.
template <class Run>
void check_halves(const SurfaceField& field, const Extreme& e, const Run& run)
{
    SurfaceCamera camera;
    REQUIRE(make_surface_camera(e.edge.pose, e.edge.image, camera) == CameraError::none);
    const SurfaceMode mode = kSurfaceModes[e.choice % 3];
    const uint32_t band_log2 = (e.choice >> 4) % 8;
    PreparedFrame by_one(field, e.edge.image.height_px, band_log2), by_two(field, e.edge.image.height_px, band_log2);
    std::vector<uint16_t> bands(by_two.bands.size(), 0xA5A5);
    SurfaceHalves halves{};
    halves.bands = bands.data();
    prepare_surface<PixelRgb565, SurfaceMode::two_by_two, SurfaceFeatures::all>(field, camera, mode, by_one.memory,
                                                                                by_one.frame);
    prepare_surface<PixelRgb565, SurfaceMode::two_by_two, SurfaceFeatures::all>(
        field, camera, mode, by_two.memory, by_two.frame, halves, [&](int32_t step) { run(halves, step); });
    // Where nothing shows, vertices and links stay as they were.
    REQUIRE(are_same(by_one, by_two));
    REQUIRE((picture(by_one.frame, e.edge) == picture(by_two.frame, e.edge)));
}

// Small meshes from ordinary eyes, and extreme ones from extreme eyes, opaque and see-through.
template <class Run>
void check_many_halves(uint32_t fields, const Run& run)
{
    constexpr int32_t kSide = 96;
    constexpr uint32_t kViewsAField = 8;
    Choices choices(33);
    Extremes extremes(34);
    std::minstd_rand random(35);
    const OpenedSurface ball(surface_file(bumpy_ball())), sheet(surface_file(wavy_sheet()));
    const OpenedGlass glass(see_through_file(bumpy_ball(), 60));
    for (uint32_t k = 0; k < fields; ++k) {
        INFO("field " << k);
        const OpenedSurface extreme(ExtremeSurfaces(choices, kLargestSurface).next());
        const OpenedGlass extreme_glass(ExtremeSurfaces(choices, kLargestSurface).next_see_through());
        REQUIRE(extreme.error() == FieldError::none);
        REQUIRE(extreme_glass.error() == FieldError::none);
        for (uint32_t view = 0; view < kViewsAField; ++view) {
            const View eye = random_view(random, kSide);
            const Extreme ordinary = {{eye.pose, eye.image, 0, 0, kSide, kSide}, extremes.below(1u << 24)};
            check_halves(ball.field(), ordinary, run);
            check_halves(sheet.field(), ordinary, run);
            check_halves(glass.field(), ordinary, run);
            check_halves(extreme.field(), extremes.next(), run);
            check_halves(extreme_glass.field(), extremes.next(), run);
        }
    }
}

}  // namespace lumi::test
