// SPDX-License-Identifier: MIT
// Frames drawn by the calls of lumi.h from C99, of every kind of field that the build draws: the bits of C++ views.

#include "c/views.h"
#include "lumi/attitude.h"
#include "surface/gloss_bytes.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr lumi_orbit kOrbits[] = {
    {LUMI_DEGREES(30), LUMI_DEGREES(-20), LUMI_RADII(5) / 2, LUMI_FIT_SPHERE, LUMI_NO_ZOOM},
    {LUMI_DEGREES(-110), LUMI_DEGREES(67), LUMI_RADII(4), LUMI_DEGREES(24), 3 * LUMI_NO_ZOOM / 2}};
constexpr lumi_quaternion kTurn = {9000, -4000, 11000, 2500};
constexpr lumi_colour kColour = {40, 90, 200};

// Pixels of a frame and its coverage, begun with what a stripe may have held before.
struct Drawn {
    Bytes pixels, coverage;

    Drawn() : coverage(size_t{kWidth} * kHeight, 0x33)
    {
        for (uint32_t k = 0; k < kWidth * kHeight * Pixel::kBytes; ++k)
            pixels.push_back(static_cast<uint8_t>(scattered(k)));
    }
};

template <class AnyView>
ViewError look_in_cpp(AnyView& view, const frame_in_c& f, uint8_t screen_mode)
{
    const lumi_orbit& o = f.orbit;
    const Orbit orbit = {o.azimuth_turns32, o.elevation_turns32, o.distance_q20, o.fov_turns32, o.zoom_q16};
    const uint32_t fov = image_of(orbit, kWidth, kHeight).fov_turns32;
    const auto mode = static_cast<typename AnyView::Mode>(f.eye == EYE_OF_SCREEN ? screen_mode : f.mode);
    switch (f.eye) {
        case EYE_OF_POSE:
            return view.look(pose_of(orbit), fov, mode);
        case EYE_HELD:
            return view.look(held_pose({f.turn.w, f.turn.x, f.turn.y, f.turn.z}, o.distance_q20), fov, mode);
        case EYE_TO_THE_RIGHT:
            return view.look(moved_right(pose_of(orbit), f.offset_q20), fov, mode);
        case EYE_ROLLED:
            return view.look(rolled(pose_of(orbit), 3 * o.azimuth_turns32), fov, mode);
        default:
            return view.look(orbit, mode);
    }
}

template <class AnyView>
ViewError draw_in_cpp(AnyView& view, const frame_in_c& f, const Stripe& stripe)
{
    if (f.background == OVER_COLOUR) return view.draw(stripe, OverColour{{f.colour.r, f.colour.g, f.colour.b}});
    if (f.background == OVER_STRIPE) return view.draw(stripe, OverStripe{});
    if constexpr (std::is_same_v<typename AnyView::Mode, SurfaceMode>)
        if (f.background == OVER_NOTHING) return view.draw(stripe, OverNothing{});
    return view.draw(stripe);
}

template <class AnyView>
void draw_stripe_in_cpp(AnyView& view, const frame_in_c& f, int32_t y, Drawn& out)
{
    constexpr uint32_t kStride = kWidth * Pixel::kBytes;
    const int32_t rows = std::min(kRows, kHeight - y);
    const uint32_t at = static_cast<uint32_t>(y);
    REQUIRE(draw_in_cpp(view, f, {out.pixels.data() + at * kStride, 0, y, kWidth, rows, kStride}) == ViewError::none);
    if constexpr (std::is_same_v<typename AnyView::Mode, SurfaceMode>)
        if (f.background == OVER_NOTHING)
            REQUIRE(view.draw_coverage({out.coverage.data() + at * kWidth, 0, y, kWidth, rows, kWidth}) ==
                    ViewError::none);
}

// A view of C and one of C++.
template <class AnyView>
class Pair
{
public:
    Pair(const Bytes& field, uint8_t mode) : field_(field), c_(field, mode)
    {
        REQUIRE(cpp_->open(field_.data(), field_.size()) == ViewError::none);
    }

    void look(const frame_in_c& f)
    {
        REQUIRE(look_in_c(c_.get(), &f) == 0);
        REQUIRE(look_in_cpp(*cpp_, f, c_.screen().mode) == ViewError::none);
        const lumi_rect by_c = lumi_bounds(c_.get());
        const PixelRect by_cpp = cpp_->bounds();
        CHECK((by_c.x_px == by_cpp.x_px && by_c.y_px == by_cpp.y_px && by_c.width_px == by_cpp.width_px &&
               by_c.height_px == by_cpp.height_px));
        by_c_ = by_cpp_ = Drawn();
    }

    void draw_stripe(const frame_in_c& f, int32_t y)
    {
        uint8_t* const coverage = f.background == OVER_NOTHING ? by_c_.coverage.data() : nullptr;
        REQUIRE(draw_stripe_in_c(c_.get(), &f, y, by_c_.pixels.data(), coverage) == 0);
        draw_stripe_in_cpp(*cpp_, f, y, by_cpp_);
    }

    bool are_same() const { return by_c_.pixels == by_cpp_.pixels && by_c_.coverage == by_cpp_.coverage; }
    bool draws_anything() const { return by_c_.pixels != Drawn().pixels; }
    const lumi_screen& screen() const { return c_.screen(); }

private:
    Bytes field_;
    ViewInC c_;
    std::unique_ptr<AnyView> cpp_ = std::make_unique<AnyView>();
    Drawn by_c_, by_cpp_;
};

frame_in_c frame_of(const lumi_screen& screen, uint8_t mode, int eye, int background, const lumi_orbit& orbit)
{
    return {screen,
            Pixel::kBytes,
            mode,
            static_cast<frame_eye>(eye),
            orbit,
            kTurn,
            LUMI_RADII(1) / 16,
            static_cast<frame_background>(background),
            kColour};
}

// Every eye over every background in every mode; how many stripes were compared.
template <class AnyView>
void check_frames(const Bytes& field, uint8_t screen_mode, const std::vector<uint8_t>& modes, int backgrounds)
{
    Pair<AnyView> pair(field, screen_mode);
    uint32_t stripes = 0;
    for (const uint8_t mode : modes)
        for (int eye = 0; eye < EYES; ++eye)
            for (int background = 0; background < backgrounds; ++background)
                for (const lumi_orbit& orbit : kOrbits) {
                    INFO("mode " << +mode << ", eye " << eye << ", background " << background);
                    const frame_in_c f = frame_of(pair.screen(), mode, eye, background, orbit);
                    pair.look(f);
                    for (int32_t y = 0; y < kHeight; y += kRows, ++stripes) pair.draw_stripe(f, y);
                    CHECK(pair.are_same());
                    CHECK(pair.draws_anything());
                }
    CHECK(stripes == modes.size() * EYES * static_cast<uint32_t>(backgrounds) * std::size(kOrbits) * 5);
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
    Drawn out;
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
    Drawn before, after;
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
