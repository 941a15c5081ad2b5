// SPDX-License-Identifier: MIT
// Every machine and compiler draws the same bits, and a change of core changes none unless it says so. Whoever means to
// change a picture writes the CRC here that the test tells.
#include <catch2/catch.hpp>
#include <vector>

#include "lumi/chord/render_spans.h"
#include "lumi/chord/view.h"
#include "lumi/detail/crc32.h"
#include "lumi/surface/view.h"
#include "surface/gloss_bytes.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr int32_t kWidth = 41, kHeight = 33;
using Small = Screen<kWidth, kHeight, kHeight, PixelRgb565>;

// Eyes on every side, from next to the sphere to far away, some of them over the poles, whole and zoomed.
Orbit eye(uint32_t k)
{
    const uint32_t elevation = k % 7 == 0 ? degrees(90) : k % 7 == 1 ? degrees(-90) : scattered(3 * k) << 8;
    const int32_t distance = radii(1) + static_cast<int32_t>(scattered(3 * k + 1) % 5 * 600000 + 20000);
    return {scattered(3 * k + 2) << 8, elevation, distance, kFitSphere, k % 3 == 0 ? 3 * kNoZoom : kNoZoom};
}

uint32_t crc_of(uint32_t crc, const void* bytes, size_t size)
{
    return crc32(crc, static_cast<const uint8_t*>(bytes), static_cast<uint32_t>(size));
}

template <class Draw>
uint32_t crc_of_frames(uint32_t frames, Draw draw)
{
    uint32_t crc = 0;
    std::vector<uint16_t> pixels(kWidth * kHeight);
    const Stripe stripe = {reinterpret_cast<uint8_t*>(pixels.data()), 0, 0, kWidth, kHeight, 2 * kWidth};
    for (uint32_t k = 0; k < frames; ++k) {
        std::fill(pixels.begin(), pixels.end(), uint16_t{0x1234});
        draw(k, stripe);
        crc = crc_of(crc, pixels.data(), 2 * pixels.size());
    }
    return crc;
}

template <class Texel>
Bytes chord_bytes()
{
    const TestLayout layout = layout_of(150, 400, Texel::kFormat);
    constexpr uint32_t kBytes = format::bytes_per_texel(Texel::kFormat);
    const auto value = [](uint32_t i, uint32_t k) {  // with holes
        return static_cast<uint8_t>(k / kBytes % 5 < 2 ? 0 : scattered(i * 5000 + k));
    };
    std::vector<TestSection> sections = {layout_section(layout), texel_section(layout, value)};
    if (layout.texel == TexelFormat::palette8) sections.push_back(palette_section());
    return file_of(sections);
}

template <class Texel>
uint32_t crc_of_chords()
{
    const Bytes bytes = chord_bytes<Texel>();
    Field field;
    REQUIRE(open_field(bytes.data(), bytes.size(), field) == FieldError::none);
    const OverColour colour{{40, 80, 160}};
    return crc_of_frames(60, [&](uint32_t k, const Stripe& stripe) {
        Camera camera;
        REQUIRE(make_camera(pose_of(eye(k)), image_of(eye(k), kWidth, kHeight), camera) == CameraError::none);
        const auto by_spans = [&](auto reconstruction) {
            return render_spans<decltype(reconstruction), Texel, PixelRgb565>(field, camera, colour, stripe,
                                                                              2 << k % 4);
        };
        const auto exactly = [&](auto reconstruction) {
            return render<decltype(reconstruction), Texel, PixelRgb565>(field, camera, colour, stripe);
        };
        const RenderError error = k % 5 == 0   ? by_spans(Nearest())
                                  : k % 5 == 1 ? exactly(Paper<9>())
                                  : k % 5 == 2 ? exactly(Paper<5>())
                                  : k % 5 == 3 ? exactly(Linear())
                                               : by_spans(Linear());
        REQUIRE(error == RenderError::none);
    });
}

template <uint32_t kSeeThroughPatches, uint32_t kGloss = 0>
uint32_t crc_of_surfaces(const Bytes& bytes)
{
    static lumi::View<SurfaceDrawing<98, 128, SurfaceMode::two_by_two, kSeeThroughPatches, 98, 0, 0, kGloss>, Small>
        view;
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    return crc_of_frames(60, [&](uint32_t k, const Stripe& stripe) {
        REQUIRE(view.look(eye(k), static_cast<SurfaceMode>(k % 3)) == ViewError::none);
        REQUIRE(view.draw(stripe, OverColour{{40, 80, 160}}) == ViewError::none);
    });
}

}  // namespace

TEST_CASE("cameras of chord fields have the same numbers on every machine")
{
    uint32_t crc = 0;
    for (uint32_t k = 0; k < 300; ++k) {
        Image image = {1 + static_cast<int32_t>(scattered(k) % 8192),
                       1 + static_cast<int32_t>(scattered(k + 500) % 900),
                       degrees(1) + scattered(k + 1000) % degrees(119)};
        image.shift_x_q8 = static_cast<int32_t>(scattered(k + 2000)) % (image.width_px * 256);
        image.shift_y_q8 = -static_cast<int32_t>(scattered(k + 3000)) % (image.height_px * 256);
        Camera camera;
        REQUIRE(make_camera(pose_of(eye(k)), image, camera) == CameraError::none);
        for (const AffineQ40& affine : {camera.offset()[0], camera.offset()[1], camera.offset()[2], camera.facing()}) {
            const int64_t numbers[] = {affine.at(0, 0), affine.at(8191, 0), affine.at(0, 8191)};
            crc = crc_of(crc, numbers, sizeof numbers);
        }
        const int32_t inverse = camera.inverse_distance_q30();
        crc = crc_of(crc, &inverse, sizeof inverse);
    }
    CHECK(crc == 0x933c285d);
}

TEST_CASE("pictures of chord fields are the same on every machine")
{
    CHECK(crc_of_chords<TexelRgb888>() == 0x5f429648);
    CHECK(crc_of_chords<TexelRgb565>() == 0xe2ad22f2);
    CHECK(crc_of_chords<TexelPalette8>() == 0xa956470a);
    CHECK(crc_of_chords<TexelLuma8>() == 0xa1deb1da);
}

TEST_CASE("pictures of surface fields are the same on every machine")
{
    CHECK(crc_of_surfaces<0>(surface_file(bumpy_ball())) == 0x211807f3);
    TestSurface fine = bumpy_ball();
    fine.code_bits = 7;
    CHECK(crc_of_surfaces<0>(surface_file(fine)) == 0x61966709);
    CHECK(crc_of_surfaces<64>(see_through_file(bumpy_ball(), 70)) == 0xb0dff10c);
    const TestSurface glossy = ball_for_gloss();
    CHECK((crc_of_surfaces<0, 3>(glossy_file(glossy, any_gloss(glossy)))) == 0x491ad71e);
}

// The eye rests in every other frame, and one part or all have moved since the last one.
TEST_CASE("pictures of moving parts are the same on every machine, and so is what has changed")
{
    using Drawing = SurfaceDrawing<200, 400, SurfaceMode::two_by_two, 9, 200, 3>;
    static lumi::View<Drawing, Small> view;
    const Bytes bytes = mover_file(moving_ball(9));
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    uint32_t of_changes = 0;
    const uint32_t of_frames = crc_of_frames(60, [&](uint32_t k, const Stripe& stripe) {
        REQUIRE(view.turn(0, scattered(k) << 8) == ViewError::none);
        if (k % 3 == 0) REQUIRE(view.turn(1, scattered(k + 1) << 8) == ViewError::none);
        if (k % 3 == 0) REQUIRE(view.slide(2, static_cast<int32_t>(scattered(k + 2) % 900000)) == ViewError::none);
        REQUIRE(view.look(eye(k / 2), static_cast<SurfaceMode>(k / 2 % 3)) == ViewError::none);
        REQUIRE(view.draw(stripe, OverColour{{40, 80, 160}}) == ViewError::none);
        const ChangedRects changed = view.changed(2, 3);
        of_changes = crc_of(of_changes, changed.rect, changed.count * sizeof changed.rect[0]);
    });
    CHECK(of_frames == 0x9067a8f4);
    CHECK(of_changes == 0x2d485f39);
}

TEST_CASE("pictures of weighed lights are the same on every machine")
{
    using Drawing = SurfaceDrawing<200, 400, SurfaceMode::two_by_two, 70, 200, 5, 3>;
    static lumi::View<Drawing, Small> view;
    const Bytes bytes = lit_file(shaded_ball(9), {{"base"}, {"lamp", 40}, {"ring", 20}});
    REQUIRE(view.open(bytes.data(), bytes.size()) == ViewError::none);
    const uint32_t crc = crc_of_frames(60, [&](uint32_t k, const Stripe& stripe) {
        const auto weight = [&](uint32_t n) { return static_cast<uint16_t>(scattered(3 * k + n) % (kFullWeight + 1)); };
        if (k % 2 == 0) REQUIRE(view.set_state(k % 3, {weight(0), weight(1), weight(2)}) == ViewError::none);
        REQUIRE(view.turn(0, scattered(k) << 8) == ViewError::none);
        REQUIRE(view.look(eye(k / 2), static_cast<SurfaceMode>(k / 2 % 3)) == ViewError::none);
        REQUIRE(view.draw(stripe, OverColour{{40, 80, 160}}) == ViewError::none);
    });
    CHECK(crc == 0x4b514f0d);
}
