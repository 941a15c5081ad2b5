// SPDX-License-Identifier: MIT
// The integer renderer of guided fields against its double-precision twin, on a baked scene.
#include "draw/draw_guided.h"

#include <catch2/catch.hpp>

#include "lumi/baker/guided.h"
#include "metrics/psnr.h"
#include "quality/held_out.h"
#include "quality/truths.h"
#include "quality/twin.h"

namespace lumi::tools
{

namespace
{

using reference::Origins;
using reference::Taps;

const baker::Scene& test_scene()
{
    static std::vector<std::string> warnings;
    static const baker::Scene scene = baker::load_scene(LUMI_TEST_SCENE, {}, warnings);
    return scene;
}

baker::GuidedSettings small_settings()
{
    baker::GuidedSettings settings;
    settings.origins = 64;
    settings.chart_size = 40;
    settings.proxy_triangles = 600;
    settings.mean_resolution = 32;
    settings.samples = 2;
    return settings;
}

// A field in memory.
struct Baked {
    std::vector<uint8_t> bytes;
    GuidedField field;

    explicit Baked(const baker::GuidedSettings& settings) : bytes(baker::guided_field(test_scene(), settings).file)
    {
        REQUIRE(open_guided(bytes.data(), bytes.size(), field) == FieldError::none);
    }
};

Eye eye_at(double azimuth, double elevation, double distance, double fov_deg, int width = 96, int height = 96)
{
    Eye eye = {host::make_pose({azimuth, elevation, distance}), host::make_image(width, height, fov_deg), {}};
    REQUIRE(make_camera(eye.pose, eye.image, eye.camera) == CameraError::none);
    return eye;
}

struct Step {
    GuidedMode mode;
    reference::GuidedShading twin;
};
constexpr Step kSteps[] = {{GuidedMode::linear, {Origins::three, Taps::linear}},
                           {GuidedMode::nearest, {Origins::three, Taps::nearest}},
                           {GuidedMode::one_origin, {Origins::heaviest, Taps::nearest}}};

// One texel a pixel: where rounding decides for another texel or origin, the picture differs by a texel's step.
double least_db(GuidedMode mode)
{
    return mode == GuidedMode::linear ? 36 : mode == GuidedMode::nearest ? 32 : 27;
}

}  // namespace

TEST_CASE("guided pictures are those of the twin in every mode, with and without antialiasing")
{
    const Baked baked(small_settings());
    for (const Step& step : kSteps)
        for (const bool antialiased : {false, true}) {
            const Eye eye = eye_at(50, 30, 3, 42);
            const Picture drawn =
                draw_guided(baked.field, eye, {step.mode, antialiased, DisplayFormat::rgb888, {0, 40, 0}});
            const Picture twin = quality::draw_twin(baked.field, eye, {antialiased, step.twin}, {0, 40, 0});
            INFO(static_cast<int>(step.mode) << " " << antialiased << " " << psnr_db(drawn, twin) << " dB");
            CHECK(psnr_db(drawn, twin) > least_db(step.mode));
        }
}

TEST_CASE("guided pictures are as good as the twin's, within 0.2 dB of the same truth")
{
    const Baked baked(small_settings());
    const auto views = quality::held_out_views(quality::ViewSet::all, 4, 128);
    const auto truths = quality::truths_of(test_scene(), views, {8, 1, 0}, {});
    for (const Step& step : kSteps) {
        double drawn = 0, twin = 0;
        for (size_t v = 0; v < views.size(); ++v) {
            drawn += psnr_db(draw_guided(baked.field, views[v].eye, {step.mode}), truths[v].picture);
            twin +=
                psnr_db(quality::draw_twin(baked.field, views[v].eye, {true, step.twin}, {0, 0, 0}), truths[v].picture);
        }
        INFO(static_cast<int>(step.mode) << ": " << drawn / 4 << " dB, twin " << twin / 4);
        CHECK(std::fabs(drawn - twin) / 4 < 0.2);
    }
}

TEST_CASE("guided pictures are those of the twin from the sphere's skin, from far away, wide and narrow")
{
    const Baked baked(small_settings());
    const Eye eyes[] = {eye_at(10, 5, 1.01, 90),      eye_at(200, -60, 1.05, 120), eye_at(300, 90, 1.3, 100),
                        eye_at(77, 0, 40, 3),         eye_at(5, 45, 1000, 1),      eye_at(130, -90, 2, 60),
                        eye_at(20, 2, 3, 42, 160, 40)};
    for (const Eye& eye : eyes) {
        const Picture drawn = draw_guided(baked.field, eye);
        const Picture twin = quality::draw_twin(baked.field, eye, {}, {0, 0, 0});
        INFO("eye " << reference::length(reference::decoded(eye.pose.eye)) << ": " << psnr_db(drawn, twin) << " dB");
        CHECK(psnr_db(drawn, twin) > 30);
    }
}

TEST_CASE("guided pictures are those of the twin for every kind of texel, mean and surface")
{
    baker::GuidedSettings bytes = small_settings(), absolute = small_settings(), alone = small_settings(),
                          wide = small_settings(), focus = small_settings(), blocks = small_settings();
    bytes.texel = format::GuidedTexel::index8;
    absolute.mean_resolution = 0;
    absolute.occlusion = false;
    alone.texel = format::GuidedTexel::none;
    wide.mean_format = format::MeanFormat::rgb565;
    focus.surface = format::GuidedSurface::focus;
    focus.mean_resolution = 0;
    focus.texel = format::GuidedTexel::index8;
    blocks.texel = format::GuidedTexel::vq8;
    const Eye eye = eye_at(120, 20, 2.6, 48);
    int kind = 0;
    for (const auto& settings : {bytes, absolute, alone, wide, focus, blocks}) {
        const Baked baked(settings);
        const Picture drawn = draw_guided(baked.field, eye);
        const Picture twin = quality::draw_twin(baked.field, eye, {}, {0, 0, 0});
        INFO("kind " << kind++ << ": " << psnr_db(drawn, twin) << " dB");
        // Without a proxy, outlines are drawn by texels that are there or missing: eight bits of weight show there.
        CHECK(psnr_db(drawn, twin) > (settings.surface == format::GuidedSurface::focus ? 32 : 35));
    }
}

TEST_CASE("a field without a chart shows its mean in every mode")
{
    baker::GuidedSettings settings = small_settings();
    settings.texel = format::GuidedTexel::none;
    const Baked baked(settings);
    const Eye eye = eye_at(50, 30, 3, 42);
    const Picture mean = draw_guided(baked.field, eye, {GuidedMode::mean});
    CHECK(draw_guided(baked.field, eye, {GuidedMode::linear}).rgb == mean.rgb);
    CHECK(draw_guided(baked.field, eye, {GuidedMode::one_origin}).rgb == mean.rgb);
}

TEST_CASE("guided pictures are shown as an RGB565 or a grey display shows them")
{
    const Baked baked(small_settings());
    const Eye eye = eye_at(50, 30, 3, 42, 40, 40);
    const Picture full = draw_guided(baked.field, eye);
    const Picture coarse = draw_guided(baked.field, eye, {GuidedMode::linear, true, DisplayFormat::rgb565});
    const Picture grey = draw_guided(baked.field, eye, {GuidedMode::linear, true, DisplayFormat::grey8});
    for (size_t i = 0; i < full.rgb.size(); i += 3) {
        const Rgb8 c = unpack_rgb565(pack_rgb565({full.rgb[i], full.rgb[i + 1], full.rgb[i + 2]}));
        REQUIRE((coarse.rgb[i] == c.r && coarse.rgb[i + 1] == c.g && coarse.rgb[i + 2] == c.b));
        REQUIRE((grey.rgb[i] == grey.rgb[i + 1] && grey.rgb[i] == grey.rgb[i + 2]));
    }
}

}  // namespace lumi::tools
