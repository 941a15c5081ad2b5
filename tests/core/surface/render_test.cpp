// SPDX-License-Identifier: MIT
#include "lumi/surface/render.h"

#include <catch2/catch.hpp>
#include <climits>

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

TestSurface ball_with_neighbours()
{
    TestSurface s = bumpy_ball();
    s.has_neighbours = true;
    return s;
}

// One colour everywhere, and no view tables.
TestSurface plain_ball()
{
    TestSurface s = ball_with_neighbours();
    s.viewed = 0;
    std::fill(s.texels.begin(), s.texels.end(), uint8_t{100});
    return s;
}

const Rgb8 kPlain = {100, 155, 90};  // colour 100 of the palette

// A frame in pixels of 16 bits, drawn in rectangles of so many pixels over a background of grey stripes or a colour.
// Rows begin in the middle of a word where `is_odd`.
template <class Pixel, class Background>
Bytes picture_of(const SurfaceField& field, const View& view, SurfaceMode mode, const Background& background,
                 int32_t width, int32_t height, bool is_odd = false)
{
    std::vector<SurfaceVertex> vertices(field.vertex_count);
    std::vector<uint16_t> links(surface_links(field.patch_count)), bands(surface_bands(kSide, 3));
    SurfaceCamera camera;
    REQUIRE(make_surface_camera(view.pose, view.image, camera) == CameraError::none);
    SurfaceFrame frame;
    prepare_surface<Pixel>(field, camera, mode, {vertices.data(), links.data(), bands.data(), 3}, frame);
    std::vector<uint16_t> pixels(kSide * kSide + 1);
    for (size_t k = 0; k < pixels.size(); ++k) pixels[k] = static_cast<uint16_t>(k / kSide * 0x0841);
    uint8_t* const first = reinterpret_cast<uint8_t*>(pixels.data() + (is_odd ? 1 : 0));
    for (int32_t y = 0; y < kSide; y += height) {
        for (int32_t x = 0; x < kSide; x += width) {
            const Stripe stripe = {first + 2 * (y * kSide + x), x,        y, std::min(width, kSide - x),
                                   std::min(height, kSide - y), 2 * kSide};
            std::vector<uint32_t> samples(
                (surface_stripe_bytes<Pixel>(stripe.width_px, stripe.height_px, mode) + 3) / 4, 0x5A5A5A5A);
            render_surface<Pixel>(frame, background, stripe, samples.data());
        }
    }
    return Bytes(first, first + 2 * kSide * kSide);
}

bool is_colour(const Bytes& picture, size_t pixel, const Rgb8& c)
{
    return picture[3 * pixel] == c.r && picture[3 * pixel + 1] == c.g && picture[3 * pixel + 2] == c.b;
}

}  // namespace

TEST_CASE("a surface is the same in rectangles of any size")
{
    std::minstd_rand random(1);
    const OpenedSurface opened(surface_file(ball_with_neighbours()));
    REQUIRE(opened.error() == FieldError::none);
    for (int k = 0; k < kViews; ++k) {
        const View view = random_view(random, kSide);
        for (const SurfaceMode mode : kSurfaceModes) {
            CAPTURE(k, static_cast<int>(mode));
            SurfaceScreen screen(opened.field(), view.pose, view.image, mode, static_cast<uint32_t>(k % 6));
            const Bytes whole = screen.picture(kSide, kSide);
            CHECK((screen.picture(kSide, 1) == whole));
            CHECK((screen.picture(1, 7) == whole));
            CHECK((screen.picture(7, 3 + static_cast<int32_t>(random() % 20)) == whole));
        }
    }
}

TEST_CASE("5-6-5 pixels of a surface are the same in rectangles of any size and place, over a colour and over others")
{
    std::minstd_rand random(9);
    const OpenedSurface opened(surface_file(ball_with_neighbours()));
    const SurfaceField& field = opened.field();
    for (int k = 0; k < kViews; ++k) {
        const View view = random_view(random, kSide);
        const SurfaceMode mode = kSurfaceModes[k % 3];
        const OverColour grey{{90, 90, 90}};
        const int32_t width = 1 + static_cast<int32_t>(random() % kSide),
                      height = 1 + static_cast<int32_t>(random() % 20);
        CAPTURE(k, static_cast<int>(mode), width, height);
        const Bytes whole = picture_of<PixelRgb565>(field, view, mode, grey, kSide, kSide);
        const Bytes over = picture_of<PixelRgb565>(field, view, mode, OverStripe{}, kSide, kSide, true);
        CHECK((picture_of<PixelRgb565>(field, view, mode, grey, width, height, k % 2 == 0) == whole));
        CHECK((picture_of<PixelRgb565>(field, view, mode, OverStripe{}, width, height, true) == over));
        Bytes swapped = picture_of<PixelRgb565Swapped>(field, view, mode, grey, width, height);
        for (size_t p = 0; p < swapped.size(); p += 2) std::swap(swapped[p], swapped[p + 1]);
        CHECK((swapped == whole));
    }
}

TEST_CASE("surfaces can be drawn from every view, and show one colour as it is")
{
    const OpenedSurface opened(surface_file(plain_ball()));
    REQUIRE(opened.error() == FieldError::none);
    for (const View& view : extreme_views(kSide)) {
        for (const SurfaceMode mode : kSurfaceModes) {
            CAPTURE(view.name, static_cast<int>(mode));
            SurfaceScreen screen(opened.field(), view.pose, view.image, mode);
            REQUIRE(screen.error() == CameraError::none);
            const Bytes picture = screen.picture(view.image.width_px, 9);
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
        SurfaceScreen screen(opened.field(), look_at(eye, {0, 0, 0}, k * 11.0), image, SurfaceMode::one_sample);
        REQUIRE(screen.error() == CameraError::none);
        const Bytes picture = screen.picture(64, 16);
        size_t holes = 0;
        for (size_t p = 0; p < picture.size() / 3; ++p) holes += is_colour(picture, p, kPlain) ? 0u : 1u;
        CHECK(holes == 0);
    }
}

TEST_CASE("stripes beside the image hold background, and nothing around them is written")
{
    const OpenedSurface opened(surface_file(ball_with_neighbours()));
    const View view = extreme_views(kSide).front();
    for (const SurfaceMode mode : kSurfaceModes) {
        SurfaceScreen screen(opened.field(), view.pose, view.image, mode);
        for (const int32_t x : {INT_MIN, -40000, -41, -3, 0, 39, 40, 40000, INT_MAX - 8, INT_MAX}) {
            for (const int32_t y : {INT_MIN, -41, -2, 38, 40, 32767, INT_MAX}) {
                CAPTURE(x, y, static_cast<int>(mode));
                constexpr size_t kGuard = 64;
                Bytes bytes(kGuard + 5 * 27 + kGuard, 0xA5);
                screen.draw({bytes.data() + kGuard, x, y, 9, 5, 27});
                const auto untouched = [](uint8_t b) { return b == 0xA5; };
                CHECK(std::all_of(bytes.begin(), bytes.begin() + kGuard, untouched));
                CHECK(std::all_of(bytes.end() - kGuard, bytes.end(), untouched));
            }
        }
    }
}

TEST_CASE("what lies under a stripe stays where no surface is")
{
    const OpenedSurface opened(surface_file(ball_with_neighbours()));
    const View view = extreme_views(kSide).front();
    for (const SurfaceMode mode : kSurfaceModes) {
        SurfaceScreen screen(opened.field(), view.pose, view.image, mode);
        const Bytes over_colour = screen.picture(kSide, kSide);
        Bytes pixels;
        for (int k = 0; k < kSide * kSide; ++k)
            for (const uint8_t c : {kSurfaceBackground.r, kSurfaceBackground.g, kSurfaceBackground.b})
                pixels.push_back(c);
        std::vector<uint32_t> samples((surface_stripe_bytes(kSide, kSide, mode) + 3) / 4);
        render_surface<PixelRgb888>(screen.frame(), OverStripe(), {pixels.data(), 0, 0, kSide, kSide, 3 * kSide},
                                    samples.data());
        CAPTURE(static_cast<int>(mode));
        CHECK((pixels == over_colour));
    }
}

TEST_CASE("a surface's view colours are clamped, not wrapped")
{
    TestSurface s = bumpy_ball();
    for (const uint8_t texel : {uint8_t{0}, uint8_t{255}}) {
        std::fill(s.texels.begin(), s.texels.end(), texel);
        const OpenedSurface opened(surface_file(s));
        const View view = extreme_views(kSide).front();
        SurfaceScreen screen(opened.field(), view.pose, view.image, SurfaceMode::one_sample);
        const Bytes picture = screen.picture(kSide, kSide);
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

TEST_CASE("hostile surface fields are drawn or refused, never read beyond")
{
    const Bytes good = surface_file(ball_with_neighbours());
    std::minstd_rand random(5);
    uint32_t accepted = 0;
    for (int k = 0; k < 20 * kViews; ++k) {
        Bytes bytes = good;
        const int changes = 1 + static_cast<int>(random() % 4);
        for (int c = 0; c < changes; ++c) bytes[200 + random() % (bytes.size() - 200)] = static_cast<uint8_t>(random());
        const OpenedSurface opened(std::move(bytes));
        if (opened.error() != FieldError::none) continue;
        ++accepted;
        const View view = random_view(random, kSide);
        SurfaceScreen screen(opened.field(), view.pose, view.image, kSurfaceModes[k % 3]);
        static_cast<void>(screen.picture(kSide, 16));
    }
    CHECK(accepted > 0);
}
