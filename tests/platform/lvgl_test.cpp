// SPDX-License-Identifier: MIT
// The image decoder of platform/lvgl against a double of LVGL, which is driven as LVGL drives decoders.
#include <catch2/catch.hpp>

#include "lumi/surface/view.h"
#include "lv_lumi_image.h"
#include "surface/surface_bytes.h"

using namespace lumi;
using namespace lumi::detail;
using test::Bytes;

namespace
{

constexpr int32_t kSide = 48, kRows = 8;
constexpr lumi_screen kScreen = {kSide, kSide, kRows, LUMI_ANTIALIASED};
constexpr lumi_orbit kOrbit = {LUMI_DEGREES(30), LUMI_DEGREES(-20), LUMI_RADII(5) / 2, LUMI_FIT_SPHERE, LUMI_NO_ZOOM};
uint64_t memory[LUMI_MEMORY(98, 128, kSide, kSide, kRows) / 8 + 1];

struct Planes {
    Bytes colours = Bytes(2 * kSide * kSide, 0), coverage = Bytes(kSide * kSide, 0);
};

const Bytes& ball()
{
    static const Bytes bytes = test::surface_file(test::bumpy_ball());
    return bytes;
}

lv_lumi_image_t& opened()
{
    static lv_lumi_image_t image;
    lv_lumi_image_decoder_init();
    REQUIRE(lv_lumi_image_open(&image, memory, sizeof memory, ball().data(), ball().size(), kScreen) == 0);
    return image;
}

lv_image_decoder_dsc_t session_of(const void* source)
{
    lv_image_decoder_dsc_t session = {};
    session.src = source;
    return session;
}

// One part of the screen, by the calls of LVGL's draw/lv_draw_image.c. Each pixel is copied where it belongs.
lv_result_t draw_part(const lv_lumi_image_t& image, const lv_area_t& part, Planes& out)
{
    lv_image_decoder_t& decoder = *lv_image_decoder_create();
    lv_image_decoder_dsc_t session = session_of(&image);
    if (decoder.info(&decoder, &session, &session.header) != LV_RESULT_OK) return LV_RESULT_INVALID;
    if (decoder.open(&decoder, &session) != LV_RESULT_OK) return LV_RESULT_INVALID;
    lv_area_t done = {LV_COORD_MIN, LV_COORD_MIN, LV_COORD_MIN, LV_COORD_MIN};
    while (decoder.get_area(&decoder, &session, &part, &done) == LV_RESULT_OK) {
        const lv_image_header_t& header = session.decoded->header;
        REQUIRE((done.y2 - done.y1 + 1 == static_cast<int32_t>(header.h) && header.h <= kRows));
        const uint8_t* const alpha = session.decoded->data + header.stride * header.h;
        for (int32_t y = done.y1; y <= done.y2; ++y) {
            for (int32_t x = done.x1; x <= done.x2; ++x) {
                const size_t from =
                    static_cast<size_t>(y - done.y1) * header.stride + 2 * static_cast<size_t>(x - done.x1);
                const size_t to = static_cast<size_t>(y * kSide + x);
                std::copy_n(session.decoded->data + from, 2, out.colours.begin() + static_cast<long>(2 * to));
                out.coverage[to] = alpha[from / 2];
            }
        }
    }
    decoder.close(&decoder, &session);
    return LV_RESULT_OK;
}

Planes expected(SurfaceMode mode = SurfaceMode::antialiased)
{
    static View<SurfaceDrawing<98, 128>, Screen<kSide, kSide, kRows, PixelRgb565>> view;
    REQUIRE(view.open(ball().data(), ball().size()) == ViewError::none);
    REQUIRE(view.look(Orbit{degrees(30), degrees(-20), radii(5) / 2}, mode) == ViewError::none);
    Planes planes;
    for (int32_t y = 0; y < kSide; y += kRows) {
        uint8_t* const colours = planes.colours.data() + 2 * kSide * y;
        uint8_t* const coverage = planes.coverage.data() + kSide * y;
        REQUIRE(view.draw({colours, 0, y, kSide, kRows, 2 * kSide}, OverNothing{}) == ViewError::none);
        REQUIRE(view.draw_coverage({coverage, 0, y, kSide, kRows, kSide}) == ViewError::none);
    }
    return planes;
}

}  // namespace

TEST_CASE("LVGL gets the view's colours and coverage, however it cuts the screen")
{
    lv_lumi_image_t& image = opened();
    lv_lumi_image_set_orbit(&image, kOrbit);
    const Planes wanted = expected();
    for (const int32_t cut : {kSide, 19, 5}) {
        Planes drawn;
        for (int32_t y = 0; y < kSide; y += cut) {
            const int32_t last = std::min(y + cut, kSide) - 1;
            REQUIRE(draw_part(image, {0, y, cut - 1, last}, drawn) == LV_RESULT_OK);
            if (cut < kSide) REQUIRE(draw_part(image, {cut, y, kSide - 1, last}, drawn) == LV_RESULT_OK);
        }
        CHECK((drawn.coverage == wanted.coverage));
        CHECK((drawn.colours == wanted.colours));
    }
}

TEST_CASE("LVGL gets the mode that was set, until another is, and none finer than the screen's")
{
    lv_lumi_image_t& image = opened();
    const lv_area_t whole = {0, 0, kSide - 1, kSide - 1};
    for (const uint8_t mode : {LUMI_ONE_SAMPLE, LUMI_ANTIALIASED}) {
        lv_lumi_image_set_mode(&image, mode);
        lv_lumi_image_set_orbit(&image, kOrbit);
        Planes drawn;
        REQUIRE(draw_part(image, whole, drawn) == LV_RESULT_OK);
        const Planes wanted = expected(static_cast<SurfaceMode>(mode));
        CHECK((drawn.colours == wanted.colours && drawn.coverage == wanted.coverage));
    }
    lv_lumi_image_set_mode(&image, LUMI_TWO_BY_TWO);
    Planes drawn;
    CHECK(draw_part(image, whole, drawn) == LV_RESULT_INVALID);
    CHECK(image.error == static_cast<lumi_error>(ViewError::mode_too_fine));
    CHECK(image.is_drawn);
}

TEST_CASE("an image measures what a frame took in all its parts, by the clock that it is given")
{
    constexpr uint32_t kStep = 7;
    lv_lumi_image_t& image = opened();
    lv_lumi_image_set_clock(&image, [] {
        static uint32_t now = UINT32_MAX - 2 * kStep;  // wraps
        return now += kStep;
    });
    for (int frame = 0; frame < 2; ++frame) {
        lv_lumi_image_set_orbit(&image, kOrbit);
        CHECK(!image.is_drawn);
        Planes drawn;
        for (int32_t y = 0; y < kSide; y += kSide / 3)
            REQUIRE(draw_part(image, {0, y, kSide - 1, y + kSide / 3 - 1}, drawn) == LV_RESULT_OK);
        CHECK(image.is_drawn);
        CHECK(image.spent == 3 * kStep);
    }
}

TEST_CASE("the decoder tells an image's size, and leaves images of others alone")
{
    lv_image_decoder_t& decoder = *lv_image_decoder_create();
    lv_lumi_image_t& image = opened();
    lv_image_decoder_dsc_t session = session_of(&image);
    lv_image_header_t header = {};
    REQUIRE(decoder.info(&decoder, &session, &header) == LV_RESULT_OK);
    CHECK((header.w == kSide && header.h == kSide && header.cf == LV_COLOR_FORMAT_RGB565A8));
    lv_image_dsc_t other = image.source;  // a copy: its data is not itself
    session = session_of(&other);
    CHECK(decoder.info(&decoder, &session, &header) == LV_RESULT_INVALID);
    session = session_of("S:clock.png");
    session.src_type = LV_IMAGE_SRC_FILE;
    CHECK(decoder.info(&decoder, &session, &header) == LV_RESULT_INVALID);
}

TEST_CASE("an eye inside the sphere, and a field cut off, are errors with a text")
{
    lv_lumi_image_t& image = opened();
    lv_lumi_image_set_orbit(&image, {0, 0, LUMI_RADII(1) / 2, LUMI_FIT_SPHERE, LUMI_NO_ZOOM});
    Planes planes;
    CHECK(draw_part(image, {0, 0, kSide - 1, kSide - 1}, planes) == LV_RESULT_INVALID);
    CHECK(image.error == static_cast<lumi_error>(view_error(CameraError::eye_inside_sphere)));
    lv_lumi_image_set_orbit(&image, kOrbit);
    CHECK(draw_part(image, {0, 0, kSide - 1, kSide - 1}, planes) == LV_RESULT_OK);
    lv_lumi_image_t cut_off;
    CHECK(lv_lumi_image_open(&cut_off, memory, sizeof memory, ball().data(), ball().size() / 2, kScreen) ==
          static_cast<lumi_error>(view_error(FieldError::truncated)));
}
