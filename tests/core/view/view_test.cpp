// SPDX-License-Identifier: MIT
#include "lumi/view.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <set>
#include <string>

#include "lumi/chord/view.h"
#include "lumi/surface/view.h"
#include "surface/surface_bytes.h"
#include "surface/surface_drawing.h"

using namespace lumi;
using namespace lumi::detail;
using test::Bytes;

namespace
{

constexpr int32_t kWidth = 48, kHeight = 37, kRows = 8;
constexpr Orbit kOrbit = {degrees(30), degrees(-20), radii(5) / 2};

template <class Pixel>
using TestScreen = Screen<kWidth, kHeight, kRows, Pixel>;

template <class Pixel>
using BallView = View<SurfaceDrawing<98, 128, SurfaceMode::two_by_two>, TestScreen<Pixel>>;

Bytes ball()
{
    return test::surface_file(test::bumpy_ball());
}

Bytes chord(TexelFormat texel)
{
    return test::sample_field(test::layout_of(128, 256, texel));
}

// A frame by stripes of so many rows, with draw(stripe).
template <class Pixel, class Draw>
Bytes frame_by(int32_t rows, Draw draw)
{
    constexpr uint32_t kStride = kWidth * Pixel::kBytes;
    Bytes pixels(kStride * kHeight, 0xA5);
    for (int32_t y = 0; y < kHeight; y += rows) {
        const int32_t height = kHeight - y < rows ? kHeight - y : rows;
        draw(Stripe{pixels.data() + static_cast<uint32_t>(y) * kStride, 0, y, kWidth, height, kStride});
    }
    return pixels;
}

template <class Pixel, class AnyView>
Bytes frame_of(AnyView& view, int32_t rows = kRows)
{
    return frame_by<Pixel>(
        rows, [&](const Stripe& stripe) { REQUIRE(view.draw(stripe) == ViewError::none); });
}

// In bands of another height than the view's: no picture depends on them.
template <class Pixel>
Bytes free_surface_frame(const Bytes& bytes, SurfaceMode mode)
{
    SurfaceField field;
    REQUIRE(open_surface(bytes.data(), bytes.size(), field) == FieldError::none);
    const Image image = {kWidth, kHeight, fit_sphere(kWidth, kHeight, kOrbit.distance_q20)};
    return test::drawn<Pixel, SurfaceFeatures::view_tables>(field, {"", pose_of(kOrbit), image}, mode, OverBlack{},
                                                            {kWidth, kRows}, 3)
        .pixels();
}

template <class Pixel>
void check_surface_frames(const Bytes& bytes)
{
    static BallView<Pixel> view;
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    for (const SurfaceMode mode : {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two}) {
        REQUIRE(view.look(kOrbit, mode) == ViewError::none);
        const Bytes expected = free_surface_frame<Pixel>(bytes, mode);
        CHECK((frame_of<Pixel>(view) == expected));
        CHECK((frame_of<Pixel>(view, 3) == expected));
    }
}

template <class Texel, class Pixel>
void check_chord_frames(const Bytes& bytes)
{
    static View<ChordDrawing<Texel>, TestScreen<Pixel>> spans;
    static View<ExactChordDrawing<Texel>, TestScreen<Pixel>> exact;
    REQUIRE(spans.open(bytes.data(), bytes.size()) == ViewError::none);
    REQUIRE(exact.open(bytes.data(), bytes.size()) == ViewError::none);
    REQUIRE(spans.look(kOrbit) == ViewError::none);
    REQUIRE(exact.look(kOrbit) == ViewError::none);
    Field field;
    Camera camera;
    REQUIRE(open_field(bytes.data(), bytes.size(), field) == FieldError::none);
    REQUIRE(make_camera(pose_of(kOrbit), image_of(kOrbit, kWidth, kHeight), camera) == CameraError::none);
    CHECK((frame_of<Pixel>(spans) == frame_by<Pixel>(
                                         kRows,
                                         [&](const Stripe& stripe) {
                                             REQUIRE(render_spans<Linear, Texel, Pixel>(
                                                         field, camera, OverBlack{}, stripe, 16) == RenderError::none);
                                         })));
    CHECK((frame_of<Pixel>(exact) == frame_by<Pixel>(kRows, [&](const Stripe& stripe) {
               REQUIRE(render<Linear, Texel, Pixel>(field, camera, OverBlack{}, stripe) == RenderError::none);
           })));
}

// The answer of draw() to a stripe that is right but for one change.
template <class Change>
ViewError drawn_with(Change change)
{
    static BallView<PixelRgb565> view;
    static const Bytes bytes = ball();
    alignas(4) static uint8_t pixels[kWidth * kHeight * 2 + 2];
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    REQUIRE(view.look(kOrbit, SurfaceMode::two_by_two) == ViewError::none);
    Stripe stripe = {pixels, 0, 8, kWidth, kRows, 2 * kWidth};
    change(stripe);
    return view.draw(stripe);
}

}  // namespace

TEST_CASE("a view of a surface field draws what the free functions draw, bit for bit")
{
    check_surface_frames<PixelRgb565Swapped>(ball());
    check_surface_frames<PixelRgb888>(ball());
}

TEST_CASE("a view of a chord field draws what the free functions draw, bit for bit")
{
    check_chord_frames<TexelPalette8, PixelRgb565>(chord(TexelFormat::palette8));
    check_chord_frames<TexelRgb565, PixelGrey8>(chord(TexelFormat::rgb565));
}

TEST_CASE("views that share one buffer of samples draw, stripe by stripe in turn, what views with their own draw")
{
    using Panel = TestScreen<PixelRgb565>;
    using Fine = SurfaceDrawing<98, 128, SurfaceMode::two_by_two>;
    using Plain = SurfaceDrawing<200, 300>;  // another type: more memory, a coarser mode
    static View<Fine, Panel> fine;
    static View<Plain, Panel> plain;
    static View<Fine, SharedSamples<Panel>> shared_fine;
    static View<Plain, SharedSamples<Panel>> shared_plain;
    static View<ChordDrawing<TexelRgb565>, SharedSamples<Panel>> rays_view;
    static SamplesFor<decltype(shared_plain), decltype(rays_view), decltype(shared_fine)> samples;
    static_assert(sizeof(samples) == sizeof(decltype(fine)::Samples));
    static_assert(sizeof(fine) - sizeof(shared_fine) >= sizeof(samples) - 8);
    static_assert(sizeof(plain) - sizeof(shared_plain) >= sizeof(decltype(plain)::Samples) - 8);

    const Bytes bytes = ball(), rays = chord(TexelFormat::rgb565);
    for (ViewError error : {fine.open(bytes.data(), bytes.size()), plain.open(bytes.data(), bytes.size()),
                            shared_fine.open(bytes.data(), bytes.size()), shared_plain.open(bytes.data(), bytes.size()),
                            rays_view.open(rays.data(), rays.size())})
        REQUIRE(error == ViewError::none);
    const Orbit other = {degrees(200), degrees(40), radii(3)};
    for (ViewError error : {fine.look(kOrbit), plain.look(other), shared_fine.look(kOrbit), shared_plain.look(other),
                            rays_view.look(kOrbit)})
        REQUIRE(error == ViewError::none);

    Bytes second(size_t{kWidth} * kHeight * 2), coverage(size_t{kWidth} * kRows), expected_coverage = coverage;
    const auto same_place = [&](Stripe stripe) {
        stripe.pixels = second.data() + static_cast<uint32_t>(stripe.y_px) * stripe.stride_bytes;
        return stripe;
    };
    const Bytes first = frame_by<PixelRgb565>(kRows, [&](const Stripe& stripe) {
        REQUIRE(shared_fine.draw(stripe, OverBlack{}, samples) == ViewError::none);
        REQUIRE(rays_view.draw(same_place(stripe), OverBlack{}, samples) == ViewError::none);
        REQUIRE(shared_plain.draw(same_place(stripe), OverNothing{}, samples) == ViewError::none);
        REQUIRE(plain.draw(same_place(stripe), OverNothing{}) == ViewError::none);
        const Stripe here = {coverage.data(), 0, stripe.y_px, kWidth, stripe.height_px, kWidth};
        const Stripe there = {expected_coverage.data(), 0, stripe.y_px, kWidth, stripe.height_px, kWidth};
        REQUIRE(shared_plain.draw_coverage(here, samples) == ViewError::none);
        REQUIRE(plain.draw_coverage(there) == ViewError::none);
        CHECK(coverage == expected_coverage);
        REQUIRE(shared_plain.draw(same_place(stripe), OverBlack{}, samples) == ViewError::none);
    });
    CHECK((first == frame_of<PixelRgb565>(fine)));
    CHECK((second == frame_of<PixelRgb565>(plain)));
    CHECK(first != second);
}

TEST_CASE("a surface field at an odd address draws the same")
{
    static BallView<PixelRgb565> view;
    const Bytes bytes = ball();
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    REQUIRE(view.look(kOrbit) == ViewError::none);
    const Bytes expected = frame_of<PixelRgb565>(view);
    Bytes moved(1, 0);
    moved.insert(moved.end(), bytes.begin(), bytes.end());
    REQUIRE(view.open(moved.data() + 1, bytes.size()) == ViewError::none);
    REQUIRE(view.look(kOrbit) == ViewError::none);
    CHECK((frame_of<PixelRgb565>(view) == expected));
}

TEST_CASE("a view refuses what is no field, cut off, of another kind or too large, each by name")
{
    static BallView<PixelRgb565> view;
    static View<ChordDrawing<TexelRgb565>, TestScreen<PixelRgb565>> chord_view;
    static View<SurfaceDrawing<97, 128>> few_vertices;
    static View<SurfaceDrawing<98, 90>> few_patches;
    static View<SurfaceDrawing<98, 128, SurfaceMode::antialiased, 0, 0>> no_view_tables;
    const Bytes bytes = ball();
    const auto error_of = [](auto& any, const Bytes& b) { return any.open(b.data(), b.size()); };
    CHECK(view.open(nullptr, 100) == ViewError::bad_argument);
    CHECK(error_of(view, Bytes(5000, 0xFF)) == view_error(FieldError::bad_magic));
    CHECK(error_of(view, Bytes(5000, 0)) == view_error(FieldError::bad_magic));
    CHECK(view.open(bytes.data(), bytes.size() / 2) == view_error(FieldError::truncated));
    CHECK(view.open(bytes.data() + 8, bytes.size() - 8) == view_error(FieldError::bad_magic));
    CHECK(error_of(view, chord(TexelFormat::rgb565)) == ViewError::other_renderer);
    CHECK(error_of(chord_view, bytes) == ViewError::other_renderer);
    CHECK(error_of(chord_view, chord(TexelFormat::palette8)) == ViewError::other_renderer);
    CHECK(error_of(few_vertices, bytes) == ViewError::field_too_large);
    CHECK(error_of(few_patches, bytes) == ViewError::field_too_large);
    CHECK(error_of(no_view_tables, bytes) == ViewError::field_too_large);
}

TEST_CASE("a view without view tables draws a field that has none as any view does, on one core and on two")
{
    using Plain = View<SurfaceDrawing<98, 128, SurfaceMode::two_by_two, 0, 0>, TestScreen<PixelRgb565>>;
    static BallView<PixelRgb565> any;
    static Plain plain;
    static Plain::Halves halves;
    test::TestSurface without = test::bumpy_ball();
    without.viewed = 0;
    const Bytes bytes = test::surface_file(without);
    REQUIRE(any.open(bytes.data(), bytes.size()) == ViewError::none);
    REQUIRE(plain.open(bytes.data(), bytes.size()) == ViewError::none);
    const auto both = [&](int32_t step) {
        halves.prepare(step, 0);
        halves.prepare(step, 1);
    };
    for (uint32_t k = 0; k < 30; ++k) {
        const Orbit orbit = {k * 0x12345678u, degrees(-90) + k * degrees(6),
                             radii(1) + static_cast<int32_t>(k) * 90000 + 30000};
        const auto mode = static_cast<SurfaceMode>(k % 3);
        INFO("eye " << k);
        REQUIRE(any.look(orbit, mode) == ViewError::none);
        REQUIRE(plain.look(orbit, mode) == ViewError::none);
        const Bytes expected = frame_of<PixelRgb565>(any);
        CHECK((frame_of<PixelRgb565>(plain) == expected));
        REQUIRE(plain.look(orbit, halves, both, mode) == ViewError::none);
        CHECK((frame_of<PixelRgb565>(plain) == expected));
    }
}

TEST_CASE("flash that was written in part is found by open() or by verify()")
{
    static BallView<PixelRgb565> view;
    const Bytes bytes = ball();
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    CHECK(view.verify() == ViewError::none);
    uint32_t unseen = 0;
    for (size_t written = bytes.size() - 1; written > 100; written -= written / 8 + 1) {
        Bytes part = bytes;
        std::fill(part.begin() + static_cast<long>(written), part.end(), uint8_t{0xFF});
        if (view.open(part.data(), part.size()) != ViewError::none) continue;
        if (view.verify() == ViewError::none && part != bytes) ++unseen;
        REQUIRE(view.look(kOrbit) == ViewError::none);
        frame_of<PixelRgb565>(view);  // wrong colours, no wild read
    }
    CHECK(unseen == 0);
}

TEST_CASE("a chord field at an odd address is refused by spans and drawn exactly")
{
    static View<ChordDrawing<TexelRgb565>, TestScreen<PixelRgb565>> spans;
    static View<ExactChordDrawing<TexelRgb565>, TestScreen<PixelRgb565>> exact;
    const Bytes bytes = chord(TexelFormat::rgb565);
    Bytes moved(1, 0);
    moved.insert(moved.end(), bytes.begin(), bytes.end());
    CHECK(spans.open(moved.data() + 1, bytes.size()) == ViewError::unaligned_field);
    CHECK(exact.open(moved.data() + 1, bytes.size()) == ViewError::none);
    // A palette is read by words; texels of a byte lie anywhere.
    static View<ChordDrawing<TexelPalette8>, TestScreen<PixelRgb565>> palette;
    static View<ChordDrawing<TexelLuma8>, TestScreen<PixelRgb565>> luma;
    for (const TexelFormat texel : {TexelFormat::palette8, TexelFormat::luma8}) {
        const Bytes at_word = chord(texel);
        moved.assign(1, 0);
        moved.insert(moved.end(), at_word.begin(), at_word.end());
        if (texel == TexelFormat::palette8)
            CHECK(palette.open(moved.data() + 1, at_word.size()) == ViewError::unaligned_field);
        else
            CHECK(luma.open(moved.data() + 1, at_word.size()) == ViewError::none);
    }
}

TEST_CASE("calls in the wrong order and views that no camera takes are errors")
{
    static BallView<PixelRgb565> view;
    static View<SurfaceDrawing<98, 128>, TestScreen<PixelRgb565>> plain;
    alignas(4) static uint8_t pixels[kWidth * kRows * 2];
    const Stripe stripe = {pixels, 0, 0, kWidth, kRows, 2 * kWidth};
    const Bytes bytes = ball();
    CHECK(view.look(kOrbit) == ViewError::no_field);
    CHECK(view.verify() == ViewError::no_field);
    CHECK(view.draw(stripe) == ViewError::no_field);
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    CHECK(view.draw(stripe) == ViewError::no_look);
    CHECK(view.look({0, 0, radii(1) / 2}) == view_error(CameraError::eye_inside_sphere));
    CHECK(view.look({0, 0, INT32_MAX}) == view_error(CameraError::eye_too_far));
    CHECK(view.look({0, 0, radii(3), degrees(130)}) == view_error(CameraError::field_of_view_range));
    CHECK(view.draw(stripe) == ViewError::no_look);
    CHECK(view.look({}) == ViewError::none);
    CHECK(view.draw(stripe) == ViewError::none);
    CHECK(view.open(bytes.data(), 10) != ViewError::none);
    CHECK(view.draw(stripe) == ViewError::no_field);
    REQUIRE(plain.open(bytes.data(), bytes.size()) == ViewError::none);
    CHECK(plain.look(kOrbit, SurfaceMode::two_by_two) == ViewError::mode_too_fine);
}

TEST_CASE("a span that no renderer has is refused by name, and the frame stays")
{
    static View<ChordDrawing<TexelRgb565>, TestScreen<PixelRgb565>> view;
    const Bytes bytes = chord(TexelFormat::rgb565);
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    CHECK(view.look(kOrbit, 3) == ViewError::wrong_span);
    CHECK(view.bounds().width_px == 0);
    REQUIRE(view.look(kOrbit, 2) == ViewError::none);
    const Bytes before = frame_of<PixelRgb565>(view);
    const Orbit other = {degrees(200), degrees(60), radii(4)};
    for (const int32_t wrong : std::initializer_list<int32_t>{INT32_MIN, -16, -2, -1, 0, 1, 3, 5, 7, 9, 15, 17, 18, 32,
                                                              256 + 16, 65536, INT32_MAX})
        CHECK(view.look(other, wrong) == ViewError::wrong_span);
    CHECK((frame_of<PixelRgb565>(view) == before));
    for (const int32_t span : {2, 4, 8, 16}) CHECK(view.look(other, span) == ViewError::none);
}

TEST_CASE("a stripe that cannot be drawn is refused by name")
{
    CHECK(drawn_with([](Stripe&) {}) == ViewError::none);
    CHECK(drawn_with([](Stripe& s) { s.y_px = 32; }) == ViewError::none);  // in part below the image
    CHECK(drawn_with([](Stripe& s) { s.pixels = nullptr; }) == ViewError::no_pixels);
    CHECK(drawn_with([](Stripe& s) { s.width_px = 0; }) == ViewError::no_pixels);
    CHECK(drawn_with([](Stripe& s) { s.height_px = -1; }) == ViewError::no_pixels);
    CHECK(drawn_with([](Stripe& s) { ++s.pixels; }) == ViewError::unaligned_pixels);
    CHECK(drawn_with([](Stripe& s) { ++s.stride_bytes; }) == ViewError::unaligned_pixels);
    CHECK(drawn_with([](Stripe& s) { s.stride_bytes -= 2; }) == ViewError::short_stride);
    CHECK(drawn_with([](Stripe& s) { s.x_px = INT32_MAX; }) == ViewError::stripe_too_far);
    CHECK(drawn_with([](Stripe& s) { s.y_px = INT32_MAX - 2; }) == ViewError::stripe_too_far);
    CHECK(drawn_with([](Stripe& s) { s.height_px = kRows + 1; }) == ViewError::stripe_too_large);
}

TEST_CASE("a stripe of every width has as many rows as pixels and memory allow")
{
    static BallView<PixelRgb565> view;
    const Bytes bytes = ball();
    alignas(4) static uint8_t pixels[BallView<PixelRgb565>::kStripeBytes];
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    for (const SurfaceMode mode : {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two}) {
        REQUIRE(view.look(kOrbit, mode) == ViewError::none);
        for (int32_t width = 1; width <= kWidth; ++width) {
            const int32_t rows = view.rows_at(width);
            const auto stride = static_cast<uint32_t>(2 * width);
            INFO(width << " x " << rows);
            REQUIRE(rows >= std::min(kRows, kHeight));
            REQUIRE(rows * width * 2 <= static_cast<int32_t>(sizeof pixels));
            CHECK(view.draw({pixels, kWidth - width, 0, width, rows, stride}) == ViewError::none);
            const bool is_most = rows == kHeight || (rows + 1) * width * 2 > static_cast<int32_t>(sizeof pixels);
            if (!is_most) CHECK(view.draw({pixels, 0, 0, width, rows + 1, stride}) == ViewError::stripe_too_large);
        }
    }
}

namespace
{

// A view's frame in the middle of a page, drawn by rectangles of the page that lie in the image, in part, or beside it.
// Whatever was on the page before, what is beside the image is background.
template <class Pixel, class AnyView, class Background>
void check_page(AnyView& view, const Background& background)
{
    constexpr int32_t kPageWidth = 2 * kWidth, kPageHeight = 2 * kHeight, kLeft = 19, kTop = 11, kPart = 13;
    constexpr uint32_t kStride = kPageWidth * Pixel::kBytes;
    Bytes image(size_t{kWidth} * kHeight * Pixel::kBytes), page(size_t{kStride} * kPageHeight, 0xA5), expected = page;
    for (int32_t y = 0; y < kHeight; y += kRows)
        REQUIRE(view.draw({image.data() + static_cast<size_t>(y) * kWidth * Pixel::kBytes, 0, y, kWidth,
                           std::min(kRows, kHeight - y), kWidth * Pixel::kBytes},
                          background) == ViewError::none);
    for (int32_t y = 0; y < kPageHeight; ++y)
        for (int32_t x = 0; x < kPageWidth; ++x) {
            const bool is_in = x >= kLeft && x < kLeft + kWidth && y >= kTop && y < kTop + kHeight;
            uint8_t* const to = &expected[static_cast<size_t>(y) * kStride + static_cast<size_t>(x) * Pixel::kBytes];
            if (is_in)
                std::memcpy(to, &image[static_cast<size_t>((y - kTop) * kWidth + x - kLeft) * Pixel::kBytes],
                            Pixel::kBytes);
            else
                store_background<Pixel>(to, background);
        }
    for (int32_t y = 0; y < kPageHeight; y += kRows)
        for (int32_t x = 0; x < kPageWidth; x += kPart)
            CHECK(
                view.draw({&page[static_cast<size_t>(y) * kStride + static_cast<size_t>(x) * Pixel::kBytes], x - kLeft,
                           y - kTop, std::min(kPart, kPageWidth - x), std::min(kRows, kPageHeight - y), kStride},
                          background) == ViewError::none);
    CHECK(page == expected);
}

// The least rectangle around the pixels that are not background.
PixelRect shown_rect(const Bytes& frame, uint32_t bytes)
{
    int32_t left = kWidth, top = kHeight, right = 0, bottom = 0;
    for (int32_t y = 0; y < kHeight; ++y)
        for (int32_t x = 0; x < kWidth; ++x) {
            const uint8_t* pixel = &frame[static_cast<size_t>(y * kWidth + x) * bytes];
            if (std::all_of(pixel, pixel + bytes, [](uint8_t byte) { return byte == 0; })) continue;
            left = std::min(left, x), right = std::max(right, x + 1);
            top = std::min(top, y), bottom = std::max(bottom, y + 1);
        }
    return {left, top, right - left, bottom - top};
}

// Bounds hold what shows and are at most two pixels from it on each side.
template <class Pixel, class AnyView>
void check_bounds(AnyView& view)
{
    const PixelRect r = view.bounds(), shown = shown_rect(frame_of<Pixel>(view), Pixel::kBytes);
    const auto is_just_before = [](int32_t a, int32_t b) { return a <= b && b - a <= 2; };
    CHECK((r.x_px >= 0 && r.y_px >= 0 && r.x_px + r.width_px <= kWidth && r.y_px + r.height_px <= kHeight));
    CHECK(is_just_before(r.x_px, shown.x_px));
    CHECK(is_just_before(r.y_px, shown.y_px));
    CHECK(is_just_before(shown.x_px + shown.width_px, r.x_px + r.width_px));
    CHECK(is_just_before(shown.y_px + shown.height_px, r.y_px + r.height_px));
}

}  // namespace

TEST_CASE("what of a stripe lies beside the image is background, whatever was there")
{
    const Bytes bytes = ball();
    static BallView<PixelRgb565> view;
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    for (const SurfaceMode mode : {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two}) {
        REQUIRE(view.look(kOrbit, mode) == ViewError::none);
        check_page<PixelRgb565>(view, OverBlack{});
        check_page<PixelRgb565>(view, OverColour{{9, 200, 77}});
    }
    const Bytes rays = chord(TexelFormat::rgb565);
    static View<ChordDrawing<TexelRgb565>, TestScreen<PixelBgr888>> spans;
    static View<ExactChordDrawing<TexelRgb565>, TestScreen<PixelBgr888>> exact;
    REQUIRE(spans.open(rays.data(), rays.size()) == ViewError::none);
    REQUIRE(exact.open(rays.data(), rays.size()) == ViewError::none);
    REQUIRE(spans.look(kOrbit) == ViewError::none);
    REQUIRE(exact.look(kOrbit) == ViewError::none);
    check_page<PixelBgr888>(spans, OverColour{{9, 200, 77}});
    check_page<PixelBgr888>(exact, OverColour{{9, 200, 77}});
}

TEST_CASE("a stripe beside the image has no coverage")
{
    const Bytes bytes = ball();
    static BallView<PixelRgb565> view;
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    REQUIRE(view.look(kOrbit) == ViewError::none);
    alignas(4) uint8_t pixels[2 * kWidth * kRows];
    Bytes coverage(kWidth * kRows, 0xA5);
    const auto draw_at = [&](int32_t x, int32_t y) {
        REQUIRE(view.draw({pixels, x, y, kWidth, kRows, 2 * kWidth}, OverNothing{}) == ViewError::none);
        REQUIRE(view.draw_coverage({coverage.data(), x, y, kWidth, kRows, kWidth}) == ViewError::none);
        return std::count(coverage.begin(), coverage.end(), 0);
    };
    CHECK(draw_at(0, kHeight) == kWidth * kRows);
    CHECK(draw_at(-kWidth, 0) == kWidth * kRows);
    CHECK(draw_at(0, kHeight / 2) < kWidth * kRows / 2);
}

TEST_CASE("beside its bounds a frame is background, and the object reaches them but for two pixels")
{
    const Bytes bytes = ball(), rays = chord(TexelFormat::rgb565);
    static BallView<PixelRgb888> view;
    static View<ChordDrawing<TexelRgb565>, TestScreen<PixelRgb888>> spans;
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    REQUIRE(spans.open(rays.data(), rays.size()) == ViewError::none);
    CHECK(view.bounds().width_px == 0);
    for (const uint32_t zoom : {kNoZoom / 4, kNoZoom, 8 * kNoZoom}) {
        const Orbit orbit = {degrees(30), degrees(-20), radii(5) / 2, kFitSphere, zoom};
        for (const SurfaceMode mode : {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two}) {
            REQUIRE(view.look(orbit, mode) == ViewError::none);
            check_bounds<PixelRgb888>(view);
        }
        REQUIRE(spans.look(orbit) == ViewError::none);
        check_bounds<PixelRgb888>(spans);
        for (const PixelRect r : {view.bounds(), spans.bounds()}) {
            CHECK((r.width_px < kWidth / 2) == (zoom < kNoZoom));
            CHECK((r.height_px == kHeight) == (zoom > kNoZoom));
        }
    }
}

TEST_CASE("every error has a text of its own")
{
    std::set<std::string> texts;
    uint32_t count = 0;
    const auto add = [&](ViewError error) {
        texts.insert(error_text(error));
        ++count;
    };
    for (uint8_t k = 0; k <= static_cast<uint8_t>(FieldError::bad_gloss); ++k) add(static_cast<ViewError>(k));
    for (uint8_t k = 1; k <= static_cast<uint8_t>(CameraError::axes_not_orthonormal); ++k)
        add(view_error(static_cast<CameraError>(k)));
    for (uint8_t k = 160; k <= static_cast<uint8_t>(ViewError::wrong_span); ++k) add(static_cast<ViewError>(k));
    CHECK(texts.size() == count);
    CHECK(texts.count("unknown error") == 0);
    for (const int unknown : {127, 159, 255})
        CHECK(std::string(error_text(static_cast<ViewError>(unknown))) == "unknown error");
    texts.clear();
    for (uint8_t k = 0; k <= static_cast<uint8_t>(FieldError::bad_gloss); ++k)
        texts.insert(describe(static_cast<FieldError>(k)));
    CHECK(texts.size() == static_cast<size_t>(FieldError::bad_gloss) + 1);
    for (const char* text : {describe(FieldError::none), describe(CameraError::none), error_text(ViewError::none)})
        CHECK(std::string(text) == "no error");
}

TEST_CASE("coverage is refused by name where a stripe's pixels would be")
{
    static BallView<PixelRgb565> view;
    static uint8_t bytes_of_coverage[kWidth * (kRows + 1)];
    const Bytes bytes = ball();
    const Stripe coverage = {bytes_of_coverage, 0, 8, kWidth, kRows, kWidth};
    CHECK(view.draw_coverage(coverage) == ViewError::no_field);
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    CHECK(view.draw_coverage(coverage) == ViewError::no_look);
    REQUIRE(view.look(kOrbit, SurfaceMode::two_by_two) == ViewError::none);
    alignas(4) static uint8_t pixels[kWidth * kRows * 2];
    REQUIRE(view.draw({pixels, 0, 8, kWidth, kRows, 2 * kWidth}, OverNothing{}) == ViewError::none);
    CHECK(view.draw_coverage(coverage) == ViewError::none);
    const auto changed = [&](auto change) {
        Stripe stripe = coverage;
        change(stripe);
        return view.draw_coverage(stripe);
    };
    CHECK(changed([](Stripe& s) { s.pixels = nullptr; }) == ViewError::no_pixels);
    CHECK(changed([](Stripe& s) { s.stride_bytes = kWidth - 1; }) == ViewError::short_stride);
    CHECK(changed([](Stripe& s) { s.height_px = kRows + 1; }) == ViewError::stripe_too_large);
    CHECK(changed([](Stripe& s) { s.x_px = INT32_MAX; }) == ViewError::stripe_too_far);
}

TEST_CASE("views of chord fields refuse other files, lattices without spans and views that no camera takes")
{
    static View<ChordDrawing<TexelRgb565>, TestScreen<PixelRgb565>> spans;
    static View<ExactChordDrawing<TexelRgb565>, TestScreen<PixelRgb565>> exact;
    const auto error_of = [](auto& view, const Bytes& b) { return view.open(b.data(), b.size()); };
    CHECK(error_of(exact, ball()) == ViewError::other_renderer);
    CHECK(error_of(exact, chord(TexelFormat::luma8)) == ViewError::other_renderer);
    CHECK(error_of(exact, Bytes(5000, 0xFF)) == view_error(FieldError::bad_magic));
    test::TestLayout few;
    few.texel = TexelFormat::rgb565;
    few.origins = few.used_origins = 20;
    few.directions = 30;
    const Bytes small = test::sample_field(few);
    CHECK(error_of(spans, small) == ViewError::other_renderer);
    CHECK(error_of(exact, small) == ViewError::none);
    const Bytes bytes = chord(TexelFormat::rgb565);
    REQUIRE(error_of(spans, bytes) == ViewError::none);
    REQUIRE(error_of(exact, bytes) == ViewError::none);
    const Orbit inside = {0, 0, radii(1) / 2};
    CHECK(spans.look(inside) == view_error(CameraError::eye_inside_sphere));
    CHECK(exact.look(inside) == view_error(CameraError::eye_inside_sphere));
    CHECK(spans.bounds().width_px == 0);
    REQUIRE(spans.look(kOrbit) == ViewError::none);
    CHECK(spans.bounds().width_px > 0);
    CHECK(spans.look(inside) == view_error(CameraError::eye_inside_sphere));
    CHECK(spans.bounds().width_px > 0);
    Pose away = pose_of(kOrbit);
    const auto turned = [](const Vec3q30& v) { return Vec3q30{-v.x, -v.y, -v.z}; };
    away.forward = turned(away.forward), away.right = turned(away.right);
    REQUIRE(spans.look(away, degrees(50)) == ViewError::none);
    const PixelRect none = spans.bounds();
    CHECK((none.x_px == 0 && none.y_px == 0 && none.width_px == 0 && none.height_px == 0));
    const Bytes nothing = frame_of<PixelRgb565>(spans);
    CHECK(std::all_of(nothing.begin(), nothing.end(), [](uint8_t byte) { return byte == 0; }));
}
