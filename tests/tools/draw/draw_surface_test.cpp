// SPDX-License-Identifier: MIT
// The integer renderer of surface fields against its double-precision twin, on a baked scene.
#include "draw/draw_surface.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "lumi/twin/surface_picture.h"
#include "metrics/metrics.h"
#include "quality/references.h"
#include "support/small_surface.h"

namespace lumi::tools
{

namespace
{

const uint8_t* file_bytes()
{
    return test::small_surface().file.data();
}

SurfaceField opened()
{
    SurfaceField field;
    const auto& file = test::small_surface().file;
    REQUIRE(open_surface(file.data(), file.size(), field) == FieldError::none);
    return field;
}

Eye eye_at(double azimuth, double elevation, double distance, double fov_deg, int width = 96, int height = 96)
{
    Eye eye = {host::make_pose({azimuth, elevation, distance}), host::make_image(width, height, fov_deg), {}};
    REQUIRE(make_camera(eye.pose, eye.image, eye.camera) == CameraError::none);
    return eye;
}

// By the double-precision twin. SurfaceMode::antialiased is drawn with four samples.
Picture draw_twin(const Eye& eye, SurfaceMode mode, const Rgb8& background)
{
    const twin::SurfaceDrawing drawing = {mode == SurfaceMode::one_sample ? 1 : 2};
    const twin::SurfacePicture drawn = twin::draw_surface(file_bytes(), eye.pose, eye.image, drawing, background);
    Picture picture(drawn.width_px, drawn.height_px);
    for (size_t i = 0; i < drawn.colours.size(); ++i) {
        const double rgb[3] = {drawn.colours[i].r, drawn.colours[i].g, drawn.colours[i].b};
        for (size_t k = 0; k < 3; ++k) picture.rgb[3 * i + k] = static_cast<uint8_t>(std::lround(rgb[k]));
    }
    return picture;
}

constexpr SurfaceMode kModes[] = {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two};

}  // namespace

TEST_CASE("surface pictures are those of the twin, from the sphere's skin, from far away, wide and narrow")
{
    const SurfaceField field = opened();
    const Eye eyes[] = {eye_at(50, 30, 3, 42),     eye_at(10, 5, 1.05, 90),      eye_at(200, -60, 1.2, 120),
                        eye_at(300, 90, 1.3, 100), eye_at(77, 0, 40, 3),         eye_at(5, 45, 1000, 1),
                        eye_at(130, -90, 2, 60),   eye_at(20, 2, 3, 42, 160, 40)};
    for (const SurfaceMode mode : kModes)
        for (const Eye& eye : eyes) {
            const Picture drawn = draw_surface(field, eye, {mode, DisplayFormat::rgb888, {0, 40, 0}});
            const Picture twin = draw_twin(eye, mode, {0, 40, 0});
            INFO(name_of(mode) << ", focal length " << eye.image.fov_turns32 << ": " << psnr_db(drawn, twin) << " dB");
            CHECK(psnr_db(drawn, twin) > 26);
        }
}

// The twin of the antialiased mode is that of four samples. The twin does not blend between texels.
TEST_CASE("surface pictures are at most 0.2 dB worse than the twin's")
{
    const SurfaceField field = opened();
    const auto views = quality::held_out_views(quality::ViewSet::all, 4, 128);
    const auto references = quality::references_of(test::cube_scene(), views, {8, 1, 0}, {});
    for (const SurfaceMode mode : kModes) {
        double drawn = 0, twin = 0;
        for (size_t v = 0; v < views.size(); ++v) {
            drawn += psnr_db(draw_surface(field, views[v].eye, {mode}), references[v].picture);
            twin += psnr_db(draw_twin(views[v].eye, mode, {0, 0, 0}), references[v].picture);
        }
        INFO(name_of(mode) << ": " << drawn / 4 << " dB, twin " << twin / 4);
        CHECK(drawn / 4 > 24);
        CHECK(drawn / 4 > twin / 4 - (mode == SurfaceMode::antialiased ? 1.5 : 0.2));
    }
}

TEST_CASE("surface pictures are shown as an RGB565 or a grey display shows them")
{
    const SurfaceField field = opened();
    const Eye eye = eye_at(50, 30, 3, 42, 40, 40);
    const Picture full = draw_surface(field, eye);
    const Picture coarse = draw_surface(field, eye, {SurfaceMode::two_by_two, DisplayFormat::rgb565});
    const Picture grey = draw_surface(field, eye, {SurfaceMode::two_by_two, DisplayFormat::grey8});
    CHECK(psnr_db(full, coarse) > 36);
    for (size_t i = 0; i < full.rgb.size(); i += 3) {
        const Rgb8 c =
            detail::unpack_rgb565(detail::pack_rgb565({coarse.rgb[i], coarse.rgb[i + 1], coarse.rgb[i + 2]}));
        REQUIRE((coarse.rgb[i] == c.r && coarse.rgb[i + 1] == c.g && coarse.rgb[i + 2] == c.b));
        REQUIRE(grey.rgb[i] == detail::luma({full.rgb[i], full.rgb[i + 1], full.rgb[i + 2]}));
    }
}

}  // namespace lumi::tools
