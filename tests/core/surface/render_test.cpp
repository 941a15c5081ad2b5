// SPDX-License-Identifier: MIT
#include "lumi/surface/render.h"

#include <catch2/catch.hpp>

#include "surface_bytes.h"
#include "surface_drawing.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr int32_t kSide = 40;
#ifdef LUMI_TEST_LIGHT
constexpr int kViews = 6;
#else
constexpr int kViews = 60;
#endif

// One colour everywhere, and no view tables.
TestSurface plain_ball()
{
    TestSurface s = bumpy_ball();
    s.viewed = 0;
    std::fill(s.texels.begin(), s.texels.end(), uint8_t{100});
    return s;
}

const Rgb8 kPlain = {100, 155, 90};  // colour 100 of the palette

template <class Pixel, class Background>
Drawn<Pixel> drawn_plain(const SurfaceField& field, const View& view, SurfaceMode mode, const Background& background,
                         const Area& area = {})
{
    return drawn<Pixel, SurfaceFeatures::view_tables>(field, view, mode, background, area);
}

bool is_colour(const Bytes& picture, size_t pixel, const Rgb8& c)
{
    return picture[3 * pixel] == c.r && picture[3 * pixel + 1] == c.g && picture[3 * pixel + 2] == c.b;
}

}  // namespace

TEST_CASE("a surface is the same in rectangles of any size")
{
    std::minstd_rand random(1);
    const OpenedSurface opened(surface_file(bumpy_ball()));
    REQUIRE(opened.error() == FieldError::none);
    for (int k = 0; k < kViews; ++k) {
        const View view = random_view(random, kSide);
        for (const SurfaceMode mode : kSurfaceModes) {
            CAPTURE(k, static_cast<int>(mode));
            const auto in = [&](const Area& area) {
                return surface_picture(opened.field(), view, mode, area, static_cast<uint32_t>(k % 6));
            };
            const Bytes whole = in({});
            CHECK((in({kSide, 1}) == whole));
            CHECK((in({1, 7}) == whole));
            CHECK((in({7, 3 + static_cast<int32_t>(random() % 20)}) == whole));
        }
    }
}

TEST_CASE(
    "5-6-5 pixels and coverage of a surface are the same in rectangles of any size and place, over a colour and others")
{
    std::minstd_rand random(9);
    const OpenedSurface opened(surface_file(bumpy_ball()));
    const SurfaceField& field = opened.field();
    for (int k = 0; k < kViews; ++k) {
        const View view = random_view(random, kSide);
        const SurfaceMode mode = kSurfaceModes[k % 3];
        const OverColour grey{{90, 90, 90}};
        const int32_t width = 1 + static_cast<int32_t>(random() % kSide),
                      height = 1 + static_cast<int32_t>(random() % 20);
        const Area area = {width, height, k % 2 == 0}, odd = {width, height, true};
        CAPTURE(k, static_cast<int>(mode), width, height);
        const Bytes whole = drawn_plain<PixelRgb565>(field, view, mode, grey).pixels();
        const Bytes over = drawn_plain<PixelRgb565>(field, view, mode, OverStripe{}, {kSide, kSide, true}).pixels();
        CHECK((drawn_plain<PixelRgb565>(field, view, mode, grey, area).pixels() == whole));
        CHECK((drawn_plain<PixelRgb565>(field, view, mode, OverStripe{}, odd).pixels() == over));
        Bytes swapped = drawn_plain<PixelRgb565Swapped>(field, view, mode, grey, {width, height}).pixels();
        for (size_t p = 0; p < swapped.size(); p += 2) std::swap(swapped[p], swapped[p + 1]);
        CHECK((swapped == whole));
        Drawn<PixelArgb8888> clear = drawn_plain<PixelArgb8888>(field, view, mode, OverNothing{});
        Drawn<PixelArgb8888> cut = drawn_plain<PixelArgb8888>(field, view, mode, OverNothing{}, area);
        CHECK((cut.pixels() == clear.pixels()));
        CHECK((cut.coverage == clear.coverage));
    }
}

TEST_CASE("surfaces can be drawn from every view, and show one colour as it is")
{
    const OpenedSurface opened(surface_file(plain_ball()));
    REQUIRE(opened.error() == FieldError::none);
    for (const View& view : extreme_views(kSide)) {
        for (const SurfaceMode mode : kSurfaceModes) {
            CAPTURE(view.name, static_cast<int>(mode));
            const Bytes picture = surface_picture(opened.field(), view, mode, {kMaxImageSide, 9});
            size_t covered = 0, others = 0;
            for (size_t p = 0; p < picture.size() / 3; ++p) {
                covered += is_colour(picture, p, kPlain) ? 1u : 0u;
                others += !is_colour(picture, p, kPlain) && !is_colour(picture, p, kSurfaceBackground) ? 1u : 0u;
            }
            CHECK((covered + others > 0 || !view.visible || view.image.width_px == 1));
            if (mode == SurfaceMode::one_sample) CHECK(others == 0);
        }
    }
}

TEST_CASE("a closed surface has no holes however near it is")
{
    const OpenedSurface opened(surface_file(plain_ball()));
    std::minstd_rand random(2);
    for (int k = 0; k < kViews; ++k) {
        // Towards the middle, so near that the ball, never below 0.5 R, fills the picture.
        const double angle = k * 0.7, height = 0.9 * std::sin(k * 1.3), r = std::sqrt(1 - height * height);
        const double distance = 1.02 + 0.001 * (k * k % 180);
        const Vec3 eye = distance * Vec3{r * std::cos(angle), r * std::sin(angle), height};
        const Image image = {64, 64, degrees(2 + k % 40)};
        CAPTURE(k, distance);
        const Bytes picture = surface_picture(opened.field(), {"", look_at(eye, {0, 0, 0}, k * 11.0), image},
                                              SurfaceMode::one_sample, {64, 16});
        size_t holes = 0;
        for (size_t p = 0; p < picture.size() / 3; ++p) holes += is_colour(picture, p, kPlain) ? 0u : 1u;
        CHECK(holes == 0);
    }
}

TEST_CASE("stripes that would end beyond the last coordinate hold background up to it, and nothing else is written")
{
    using Place = std::pair<int32_t, int32_t>;
    constexpr int32_t kWidth = 9, kHeight = 5;
    constexpr size_t kStride = 3 * kWidth, kGuard = 64;
    const OpenedSurface opened(surface_file(bumpy_ball()));
    for (const SurfaceMode mode : kSurfaceModes) {
        PreparedFrame made(opened.field(), kSide);
        made.prepare<PixelRgb888, SurfaceFeatures::view_tables>(opened.field(), extreme_views(kSide).front(), mode);
        for (const auto& [x, y] : {Place{INT32_MAX - 8, 0}, Place{INT32_MAX, 0}, Place{0, INT32_MAX}}) {
            Bytes expected(kGuard + kHeight * kStride + kGuard, 0xA5), bytes = expected;
            draw_stripe<PixelRgb888, SurfaceFeatures::view_tables>(made.frame, OverColour{{1, 1, 1}},
                                                                   {&bytes[kGuard], x, y, kWidth, kHeight, kStride});
            for (int32_t row = 0; row < std::min(kHeight, INT32_MAX - y); ++row)
                std::fill_n(&expected[kGuard + static_cast<size_t>(row) * kStride], 3 * std::min(kWidth, INT32_MAX - x),
                            1);
            CAPTURE(x, y, static_cast<int>(mode));
            CHECK((bytes == expected));
        }
    }
}

TEST_CASE("what lies under a stripe stays where no surface is")
{
    const OpenedSurface opened(surface_file(bumpy_ball()));
    const View view = extreme_views(kSide).front();
    for (const SurfaceMode mode : kSurfaceModes) {
        PreparedFrame made(opened.field(), kSide);
        made.prepare<PixelRgb888, SurfaceFeatures::view_tables>(opened.field(), view, mode);
        Bytes pixels;
        for (int k = 0; k < kSide * kSide; ++k)
            for (const uint8_t c : {kSurfaceBackground.r, kSurfaceBackground.g, kSurfaceBackground.b})
                pixels.push_back(c);
        draw_stripe<PixelRgb888, SurfaceFeatures::view_tables>(made.frame, OverStripe{},
                                                               {pixels.data(), 0, 0, kSide, kSide, 3 * kSide});
        CAPTURE(static_cast<int>(mode));
        CHECK((pixels == surface_picture(opened.field(), view, mode)));
    }
}

TEST_CASE("a surface's view colours are clamped, not wrapped")
{
    TestSurface s = bumpy_ball();
    for (const uint8_t texel : {uint8_t{0}, uint8_t{255}}) {
        std::fill(s.texels.begin(), s.texels.end(), texel);
        const OpenedSurface opened(surface_file(s));
        const View view = extreme_views(kSide).front();
        const Bytes picture = surface_picture(opened.field(), view, SurfaceMode::one_sample);
        // Colour 0 is (0, 255, 40), 255 is (255, 0, 231): views add at most 127 levels, and some by rounding.
        size_t wrong = 0;
        for (size_t p = 0; p < picture.size() / 3; ++p) {
            if (is_colour(picture, p, kSurfaceBackground)) continue;
            const bool fits = texel == 0 ? picture[3 * p] <= 136 && picture[3 * p + 1] >= 118
                                         : picture[3 * p] >= 118 && picture[3 * p + 1] <= 136;
            wrong += fits ? 0u : 1u;
        }
        CHECK(wrong == 0);
    }
}
