// SPDX-License-Identifier: MIT
// Moving parts by the calls of lumi.h, in a build that names them and in one that does not.
#include "c/views.h"
#include "surface/parts_bytes.h"

using namespace lumi;
using namespace lumi::test;

namespace
{

constexpr lumi_orbit kOrbit = {LUMI_DEGREES(30), LUMI_DEGREES(20), LUMI_RADII(3), LUMI_FIT_SPHERE, LUMI_NO_ZOOM};

}  // namespace

TEST_CASE("calls for moving parts without a view are errors, and nothing has changed")
{
    CHECK(lumi_turn(nullptr, 0, 0) == code(ViewError::no_field));
    CHECK(lumi_slide(nullptr, 0, 0) == code(ViewError::no_field));
    CHECK(lumi_changed(nullptr, 1, 1).count == 0);
}

TEST_CASE("fields that rest change as a whole, and do not turn")
{
    const ViewInC view(surface_bytes(), LUMI_ANTIALIASED);
    CHECK(lumi_turn(view.get(), 0, 0) != 0);
    CHECK(lumi_slide(view.get(), 0, 0) != 0);
    CHECK(lumi_changed(view.get(), 1, 1).count == 0);  // before a look
    REQUIRE(lumi_look(view.get(), kOrbit) == 0);
    const lumi_changes changed = lumi_changed(view.get(), 16, 16);
    REQUIRE(changed.count == 1);
    CHECK(changed.rect[0].width_px == kWidth);
    CHECK(changed.rect[0].height_px == kHeight);
}

#ifdef LUMI_C_PARTS

TEST_CASE("chord fields change as a whole, and do not turn")
{
    const ViewInC view(chord_bytes(TexelFormat::rgb565), 4);
    CHECK(lumi_turn(view.get(), 0, 0) == code(ViewError::other_renderer));
    CHECK(lumi_slide(view.get(), 0, 0) == code(ViewError::other_renderer));
    REQUIRE(lumi_look(view.get(), kOrbit) == 0);
    const lumi_changes changed = lumi_changed(view.get(), 16, 16);
    REQUIRE(changed.count == 1);
    CHECK(changed.rect[0].width_px == kWidth);
}

TEST_CASE("parts that C moves are drawn as those that C++ moves")
{
    using MovingView = lumi::View<SurfaceDrawing<200, 400, SurfaceMode::two_by_two, 9, 200, 3>, TestScreen>;
    Pair<MovingView> pair(mover_file(moving_ball(9)), LUMI_TWO_BY_TWO);
    for (uint32_t k = 0; k < 12; ++k) {
        const uint32_t angle = k * 0x13579BDF;
        const int32_t offset = static_cast<int32_t>(k) << 15;
        REQUIRE(lumi_turn(pair.c(), 0, angle) == 0);
        REQUIRE(lumi_slide(pair.c(), 2, offset) == 0);
        REQUIRE(pair.cpp().turn(0, angle) == ViewError::none);
        REQUIRE(pair.cpp().slide(2, offset) == ViewError::none);
        const uint8_t mode = k % 6 < 4 ? LUMI_ANTIALIASED : LUMI_TWO_BY_TWO;
        pair.check(frame_of(pair.screen(), mode, EYE_OF_MODE, OVER_DEFAULT, kOrbit));
        const lumi_changes told = lumi_changed(pair.c(), 4, 2);
        const ChangedRects wanted = pair.cpp().changed(4, 2);
        REQUIRE(told.count == wanted.count);
        for (uint32_t r = 0; r < told.count; ++r) {
            CHECK(told.rect[r].x_px == wanted.rect[r].x_px);
            CHECK(told.rect[r].y_px == wanted.rect[r].y_px);
            CHECK(told.rect[r].width_px == wanted.rect[r].width_px);
            CHECK(told.rect[r].height_px == wanted.rect[r].height_px);
        }
    }
    CHECK(lumi_turn(pair.c(), 2, 0) == code(ViewError::bad_argument));
    CHECK(lumi_slide(pair.c(), 1, 0) == code(ViewError::bad_argument));
}

#else

TEST_CASE("moving parts are refused by name where the build does not draw them")
{
    const Bytes file = mover_file(moving_ball());
    CHECK(lumi_memory_size(file.data(), file.size(), {kWidth, kHeight, kRows, LUMI_ANTIALIASED}) == 0);
    std::vector<uint64_t> memory(20000);
    lumi_view* view = nullptr;
    const lumi_screen screen = {kWidth, kHeight, kRows, LUMI_ANTIALIASED};
    CHECK(lumi_open(memory.data(), 8 * memory.size(), file.data(), file.size(), screen, &view) ==
          static_cast<lumi_error>(FieldError::parts));
    CHECK(lumi_turn(ViewInC(surface_bytes(), LUMI_ANTIALIASED).get(), 0, 0) == code(ViewError::other_renderer));
}

#endif
