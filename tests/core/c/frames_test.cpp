// SPDX-License-Identifier: MIT
// Frames drawn by the calls of lumi.h from C99, of every kind of field that the build draws: the bits of C++ views.

#include "c/views.h"
#include "surface/gloss_bytes.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr lumi_orbit kOrbits[] = {
    {LUMI_DEGREES(30), LUMI_DEGREES(-20), LUMI_RADII(5) / 2, LUMI_FIT_SPHERE, LUMI_NO_ZOOM},
    {LUMI_DEGREES(-110), LUMI_DEGREES(67), LUMI_RADII(4), LUMI_DEGREES(24), 3 * LUMI_NO_ZOOM / 2}};

// Every eye over every background in every mode.
template <class AnyView>
void check_frames(const Bytes& field, uint8_t screen_mode, const std::vector<uint8_t>& modes, int backgrounds)
{
    Pair<AnyView> pair(field, screen_mode);
    for (const uint8_t mode : modes)
        for (int eye = 0; eye < EYES; ++eye)
            for (int background = 0; background < backgrounds; ++background)
                for (const lumi_orbit& orbit : kOrbits) {
                    INFO("mode " << +mode << ", eye " << eye << ", background " << background);
                    const frame_in_c f = frame_of(pair.screen(), mode, eye, background, orbit);
                    pair.check(f);
                    CHECK(pair.draws_anything());
                }
}

const std::vector<uint8_t> kSurfaceModes = {LUMI_ONE_SAMPLE, LUMI_ANTIALIASED, LUMI_TWO_BY_TWO};

}  // namespace

TEST_CASE("every eye, mode and background of surface fields is drawn from C as by C++, with its coverage")
{
    check_frames<SurfaceView>(surface_bytes(), LUMI_TWO_BY_TWO, kSurfaceModes, BACKGROUNDS);
}

#ifdef LUMI_C_SEE_THROUGH
TEST_CASE("every eye, mode and background of see-through fields is drawn from C as by C++, with its coverage")
{
    check_frames<SeeThroughView>(see_through_bytes(), LUMI_TWO_BY_TWO, kSurfaceModes, BACKGROUNDS);
}
#endif

#ifdef LUMI_C_GLOSS
TEST_CASE("every eye, mode and background of fields with gloss maps is drawn from C as by C++, with its coverage")
{
    using GlossView = View<SurfaceDrawing<98, 128, SurfaceMode::two_by_two, 0, 98, 0, 0, 3>, TestScreen>;
    const TestSurface ball = ball_for_gloss();
    check_frames<GlossView>(glossy_file(ball, any_gloss(ball)), LUMI_TWO_BY_TWO, kSurfaceModes, BACKGROUNDS);
}
#endif

#ifdef LUMI_C_TEXEL
namespace
{

const std::vector<uint8_t> kSpans = {2, 4, 8, 16};

}  // namespace

TEST_CASE("every eye, mode and background of chord fields of several formats is drawn from C as by C++")
{
    check_frames<ChordView<TexelRgb565>>(chord_bytes(TexelFormat::rgb565), 8, kSpans, OVER_NOTHING);
    check_frames<ChordView<TexelPalette8>>(chord_bytes(TexelFormat::palette8), 4, kSpans, OVER_NOTHING);
}

TEST_CASE("fields of both layouts are drawn side by side, stripe by stripe")
{
    Pair<SeeThroughView> see_through(see_through_bytes(), LUMI_ANTIALIASED);
    Pair<SurfaceView> surface(surface_bytes(), LUMI_TWO_BY_TWO);
    Pair<ChordView<TexelRgb565>> chord(chord_bytes(TexelFormat::rgb565), 16);
    Pair<ChordView<TexelPalette8>> palette(chord_bytes(TexelFormat::palette8), 2);
    const auto frame = [](const auto& pair, const lumi_orbit& orbit) {
        return frame_of(pair.screen(), pair.screen().mode, EYE_OF_POSE, OVER_DEFAULT, orbit);
    };
    const auto each = [&](const auto& use) { use(see_through), use(surface), use(chord), use(palette); };
    for (const lumi_orbit& orbit : kOrbits) {
        each([&](auto& pair) { pair.look(frame(pair, orbit)); });
        for (int32_t y = 0; y < kHeight; y += kRows) each([&](auto& pair) { pair.draw_stripe(frame(pair, orbit), y); });
        each([](auto& pair) { CHECK(pair.are_same()); });
    }
}

TEST_CASE("what chord fields have no pixels for is an error in C")
{
    const ViewInC view(chord_bytes(TexelFormat::rgb565), 16);
    frame_in_c f = frame_of(view.screen(), 16, EYE_OF_SCREEN, OVER_NOTHING, kOrbits[0]);
    FrameBytes out;
    REQUIRE(look_in_c(view.get(), &f) == 0);
    CHECK(draw_stripe_in_c(view.get(), &f, 0, out.pixels.data(), nullptr) == code(ViewError::other_renderer));
    f.background = OVER_DEFAULT;
    CHECK(draw_stripe_in_c(view.get(), &f, 0, out.pixels.data(), out.coverage.data()) ==
          code(ViewError::other_renderer));
    CHECK(draw_stripe_in_c(view.get(), &f, 0, out.pixels.data(), nullptr) == 0);
}

TEST_CASE("of all numbers, only spans that a renderer has are modes of chord fields in C, and others leave the frame")
{
    const Bytes field = chord_bytes(TexelFormat::rgb565);
    const ViewInC view(field, 8);
    REQUIRE(lumi_look(view.get(), kOrbits[0]) == 0);
    const lumi_rect before = lumi_bounds(view.get());
    for (int mode = 0; mode < 256; ++mode) {
        const bool is_span = mode == 2 || mode == 4 || mode == 8 || mode == 16;
        const uint8_t number = static_cast<uint8_t>(mode);
        const lumi_screen screen = {kWidth, kHeight, kRows, number};
        CHECK((lumi_memory_size(field.data(), field.size(), screen) > 0) == is_span);
        if (is_span) continue;
        std::vector<uint64_t> memory(8192);
        lumi_view* none = nullptr;
        CHECK(lumi_open(memory.data(), 65536, field.data(), field.size(), screen, &none) ==
              code(ViewError::wrong_span));
        CHECK(none == nullptr);
        CHECK(lumi_look_mode(view.get(), kOrbits[1], number) == code(ViewError::wrong_span));
    }
    CHECK(lumi_look_mode(view.get(), {0, 0, 0, 0, LUMI_NO_ZOOM}, 8) ==
          code(view_error(CameraError::eye_inside_sphere)));
    const lumi_rect after = lumi_bounds(view.get());
    CHECK((after.x_px == before.x_px && after.width_px == before.width_px && after.height_px == before.height_px));
    REQUIRE(lumi_look_mode(view.get(), kOrbits[1], 2) == 0);
    CHECK(lumi_bounds(view.get()).width_px != before.width_px);
}

TEST_CASE("a program for both layouts refuses each other field by name")
{
    const auto error_of = [](const Bytes& field, uint8_t mode) {
        std::vector<uint64_t> memory(8192);
        lumi_view* view = nullptr;
        return lumi_open(memory.data(), 65536, field.data(), field.size(), {kWidth, kHeight, kRows, mode}, &view);
    };
    CHECK(error_of(chord_bytes(TexelFormat::rgb565), 16) == 0);
    CHECK(error_of(surface_bytes(), LUMI_ANTIALIASED) == 0);
    CHECK(error_of(surface_bytes(), 16) == code(ViewError::bad_argument));
    CHECK(error_of(chord_bytes(TexelFormat::luma8), 16) == code(ViewError::other_renderer));
    Bytes cut = chord_bytes(TexelFormat::rgb565);
    cut.resize(cut.size() / 2);
    CHECK(error_of(cut, 16) == code(view_error(FieldError::truncated)));
    CHECK(error_of(Bytes(5000, 0xFF), 0) == code(view_error(FieldError::bad_magic)));
    CHECK(lumi_memory_size(chord_bytes(TexelFormat::rgb565).data(), chord_bytes(TexelFormat::rgb565).size(),
                           {kWidth, kHeight, kRows, 16}) <= LUMI_MEMORY(0, 0, kWidth, kHeight, kRows));
}
#endif

TEST_CASE("views from C that no camera takes, and modes that are too fine, are errors and leave the frame")
{
    const ViewInC view(surface_bytes(), LUMI_ANTIALIASED);
    const frame_in_c f = frame_of(view.screen(), LUMI_ONE_SAMPLE, EYE_OF_MODE, OVER_DEFAULT, kOrbits[0]);
    const uint32_t fov = lumi_fov_of(view.get(), kOrbits[0]);
    const lumi_pose pose = lumi_pose_of(kOrbits[0]);
    CHECK(lumi_look_mode(nullptr, kOrbits[0], 0) == code(ViewError::no_field));
    CHECK(lumi_look_pose(nullptr, pose, fov, 0) == code(ViewError::no_field));
    CHECK(lumi_fov_of(nullptr, kOrbits[0]) == 0);
    CHECK(lumi_draw_over_colour(view.get(), {}, kColour) == code(ViewError::no_look));
    CHECK(lumi_draw_over_stripe(view.get(), {}) == code(ViewError::no_look));
    CHECK(lumi_draw_over_nothing(nullptr, {}) == code(ViewError::no_field));
    REQUIRE(look_in_c(view.get(), &f) == 0);
    FrameBytes before, after;
    for (int32_t y = 0; y < kHeight; y += kRows)
        REQUIRE(draw_stripe_in_c(view.get(), &f, y, before.pixels.data(), nullptr) == 0);
    lumi_pose skewed = pose, far = pose, inside = pose;
    skewed.up_q30.x += 1 << 20;
    far.eye_q20.x = INT32_MAX;
    inside.eye_q20 = {0, 0, LUMI_RADII(1) / 2};
    const auto look = [&](const lumi_pose& p, uint32_t fov_turns32) {
        return lumi_look_pose(view.get(), p, fov_turns32, LUMI_ONE_SAMPLE);
    };
    CHECK(look(skewed, fov) == code(view_error(CameraError::axes_not_orthonormal)));
    CHECK(look(far, fov) == code(view_error(CameraError::eye_too_far)));
    CHECK(look(inside, fov) == code(view_error(CameraError::eye_inside_sphere)));
    CHECK(look(pose, LUMI_FIT_SPHERE) == code(view_error(CameraError::field_of_view_range)));
    CHECK(lumi_look_mode(view.get(), kOrbits[0], LUMI_TWO_BY_TWO) == code(ViewError::mode_too_fine));
    CHECK(lumi_look_mode(view.get(), kOrbits[0], 200) == code(ViewError::mode_too_fine));
    for (int32_t y = 0; y < kHeight; y += kRows)
        REQUIRE(draw_stripe_in_c(view.get(), &f, y, after.pixels.data(), nullptr) == 0);
    CHECK((before.pixels == after.pixels));
}
