// SPDX-License-Identifier: MIT
// Counts of a frame of a chord field.
#include "planner/chord_work.h"

#include <catch2/catch.hpp>

#include "lumi/bench/views.h"
#include "support/test_field.h"

namespace lumi::planner
{

namespace
{

using tools::Mode;

// Counts the test field, which shows something everywhere, in stripes of 16 rows.
ChordWork work_of(uint32_t origins, uint32_t directions, const bench::View& view, int32_t span_px)
{
    tools::test::TestField layout;
    layout.origins = layout.used_origins = origins;
    layout.directions = directions;
    const std::string file = tools::test::field_bytes(layout);
    Field field;
    REQUIRE(open_field(reinterpret_cast<const uint8_t*>(file.data()), file.size(), field) == FieldError::none);
    Camera camera;
    REQUIRE(make_view_camera(view, camera) == CameraError::none);
    return frame_of(field, Mode::nearest, span_px, camera, {}).work;
}

}  // namespace

TEST_CASE("a larger lattice has more zones to set up in each stripe")
{
    const double few = work_of(64, 64, bench::kViews[0], 8)[ChordItem::made_zone];
    const double more = work_of(1024, 2048, bench::kViews[0], 8)[ChordItem::made_zone];
    CHECK(more > 2 * few);
    CHECK(work_of(64, 2048, bench::kViews[0], 8)[ChordItem::made_zone] == (few + more) / 2);
}

TEST_CASE("every pixel is drawn once, shows something or nothing, and lies over a pole or not")
{
    for (const bench::View& view : bench::kViews)
        for (const int32_t span_px : {4, 8, 16}) {
            const ChordWork work = work_of(300, 400, view, span_px);
            const double checked = (work[ChordItem::cell_pixel] + work[ChordItem::pole_pixel]) / 2;
            INFO(view.name << " " << span_px);
            CHECK(work[ChordItem::tile_pixel] + work[ChordItem::span_pixel] + checked == work[ChordItem::pixel]);
            CHECK(work[ChordItem::shown] == work[ChordItem::pixel]);
            CHECK(work[ChordItem::polar_side] > 0);
            CHECK(work[ChordItem::pole_pixel] > work[ChordItem::polar_side]);
        }
}

TEST_CASE("spans are shortened at poles, more where poles are seen")
{
    const ChordWork generic = work_of(300, 400, bench::kViews[0], 8), pole = work_of(300, 400, bench::kViews[1], 8);
    CHECK(generic[ChordItem::shortened] > 0);
    CHECK(pole[ChordItem::shortened] > generic[ChordItem::shortened]);
    CHECK(pole[ChordItem::shortened] < pole[ChordItem::span] + pole[ChordItem::checked]);
}

TEST_CASE("the outline is looked for in each stripe, and in scanlines that have none")
{
    const ChordWork work = work_of(64, 64, bench::kViews[0], 8);
    const host::ScreenSize screen;
    const double stripes = (screen.height_px + screen.stripe_rows() - 1) / screen.stripe_rows();
    CHECK(work[ChordItem::searched] >= stripes);
    CHECK(work[ChordItem::searched] >= screen.height_px - work[ChordItem::scanline]);
    CHECK(work[ChordItem::searched] <= stripes + screen.height_px - work[ChordItem::scanline]);
}

}  // namespace lumi::planner
