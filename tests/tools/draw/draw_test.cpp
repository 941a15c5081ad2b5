// SPDX-License-Identifier: MIT
#include "draw/draw.h"

#include <catch2/catch.hpp>

#include "lumi/chord/render.h"
#include "lumi/host/camera.h"
#include "metrics/metrics.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::tools
{

namespace
{

const Rgb8 kBackground = {8, 16, 24};  // unchanged by RGB565

Camera test_camera(int width, int height)
{
    Camera camera;
    const CameraError error = make_camera(host::make_pose({30, 20, 3}), host::make_image(width, height, 42), camera);
    REQUIRE(error == CameraError::none);
    return camera;
}

Field opened(const std::string& bytes)
{
    Field field;
    const FieldError error = open_field(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size(), field);
    REQUIRE(error == FieldError::none);
    return field;
}

// All in one stripe, without the tool's code.
template <class Reconstruction, class Texel>
Picture drawn_at_once(const Field& field, const Camera& camera)
{
    Picture picture(camera.width_px(), camera.height_px());
    const Stripe stripe = {
        picture.rgb.data(), 0, 0, camera.width_px(), camera.height_px(), 3u * static_cast<uint32_t>(camera.width_px())};
    const RenderError error =
        render<Reconstruction, Texel, PixelRgb888>(field, camera, OverColour{kBackground}, stripe);
    REQUIRE(error == RenderError::none);
    return picture;
}

bool is(const uint8_t* pixel, const Rgb8& colour)
{
    return pixel[0] == colour.r && pixel[1] == colour.g && pixel[2] == colour.b;
}

}  // namespace

TEST_CASE("every mode, neighbour count, texel and display format draws the sphere over the background")
{
    const Camera camera = test_camera(33, 21);
    for (const TexelFormat texel : detail::AllTexels::kFormats) {
        const std::string bytes = test::field_bytes({40, 60, 40, texel});
        const Field field = opened(bytes);
        for (const Mode mode : {Mode::nearest, Mode::linear, Mode::paper})
            for (uint32_t neighbours = 1; neighbours <= (mode == Mode::paper ? 9u : 1u); ++neighbours)
                for (const DisplayFormat display :
                     {DisplayFormat::rgb888, DisplayFormat::rgb565, DisplayFormat::grey8}) {
                    INFO("texel " << int(texel) << " mode " << int(mode) << " neighbours " << neighbours << " display "
                                  << int(display));
                    const Picture picture = draw(field, camera, {mode, neighbours, display, kBackground});
                    REQUIRE(picture.width_px == 33);
                    REQUIRE(picture.height_px == 21);
                    const Rgb8 corner = display == DisplayFormat::grey8 ? Rgb8{16, 16, 16} : kBackground;
                    const uint8_t grey = detail::luma(kBackground);
                    CHECK(is(picture.pixel(0, 0), display == DisplayFormat::grey8 ? Rgb8{grey, grey, grey} : corner));
                    CHECK_FALSE(is(picture.pixel(16, 10), corner));
                }
    }
}

TEST_CASE("drawing in stripes gives the picture that core draws at once")
{
    const Camera camera = test_camera(50, 37);
    const std::string bytes = test::field_bytes({});
    const Field field = opened(bytes);
    CHECK((draw(field, camera, {Mode::nearest, 1, DisplayFormat::rgb888, kBackground}).rgb ==
           drawn_at_once<Nearest, TexelRgb888>(field, camera).rgb));
    CHECK((draw(field, camera, {Mode::linear, 1, DisplayFormat::rgb888, kBackground}).rgb ==
           drawn_at_once<Linear, TexelRgb888>(field, camera).rgb));
    CHECK((draw(field, camera, {Mode::paper, 4, DisplayFormat::rgb888, kBackground}).rgb ==
           drawn_at_once<Paper<4>, TexelRgb888>(field, camera).rgb));
}

TEST_CASE("spans are drawn where asked for, and longer ones differ more")
{
    const Camera camera = test_camera(120, 120);
    const std::string bytes = test::field_bytes({200, 300, 200, TexelFormat::rgb888});
    const Field field = opened(bytes);
    const auto drawn = [&](Mode mode, int32_t span_px) {
        return draw(field, camera, {mode, 5, DisplayFormat::rgb888, kBackground, span_px});
    };
    const Picture exact = drawn(Mode::linear, 0);
    CHECK(drawn(Mode::linear, 1).rgb == exact.rgb);
    CHECK(drawn(Mode::nearest, 4).rgb != drawn(Mode::nearest, 0).rgb);
    const double at4 = psnr_db(drawn(Mode::linear, 4), exact);
    const double at16 = psnr_db(drawn(Mode::linear, 16), exact);
    CHECK(at16 < at4);
    CHECK(at16 > 25);
}

TEST_CASE("the paper's kernel is drawn exactly, whatever span is asked for")
{
    const Camera camera = test_camera(60, 60);
    const std::string bytes = test::field_bytes({200, 300, 200, TexelFormat::rgb888});
    const Field field = opened(bytes);
    constexpr uint32_t kMost = detail::kMaxNeighbours;
    CHECK((draw(field, camera, {Mode::paper, kMost, DisplayFormat::rgb888, kBackground, 4}).rgb ==
           drawn_at_once<Paper<kMost>, TexelRgb888>(field, camera).rgb));
}

TEST_CASE("modes and neighbour counts are told apart")
{
    // Up to four neighbours only: the paper's kernel is about as wide as the mean spacing, so that further points
    // mostly weigh nothing.
    const Camera camera = test_camera(60, 60);
    const std::string bytes = test::field_bytes({});
    const Field field = opened(bytes);
    const auto drawn = [&](Mode mode, uint32_t neighbours) {
        return draw(field, camera, {mode, neighbours, DisplayFormat::rgb888, kBackground}).rgb;
    };
    const std::vector<std::vector<uint8_t>> pictures = {drawn(Mode::nearest, 1), drawn(Mode::linear, 1),
                                                        drawn(Mode::paper, 2), drawn(Mode::paper, 4)};
    for (size_t i = 0; i < pictures.size(); ++i)
        for (size_t k = 0; k < i; ++k) {
            INFO("pictures " << k << " and " << i);
            CHECK((pictures[i] != pictures[k]));
        }
    CHECK((drawn(Mode::paper, 1) == pictures[0]));  // one neighbour is the nearest
}

TEST_CASE("an RGB565 display shows the RGB888 picture's colours rounded to its steps")
{
    const Camera camera = test_camera(40, 40);
    const std::string bytes = test::field_bytes({});
    const Field field = opened(bytes);
    const Picture fine = draw(field, camera, {Mode::linear, 1, DisplayFormat::rgb888, kBackground});
    const Picture coarse = draw(field, camera, {Mode::linear, 1, DisplayFormat::rgb565, kBackground});
    for (size_t i = 0; i < fine.rgb.size(); i += 3)
        REQUIRE(is(&coarse.rgb[i],
                   detail::unpack_rgb565(detail::pack_rgb565({fine.rgb[i], fine.rgb[i + 1], fine.rgb[i + 2]}))));
}

}  // namespace lumi::tools
