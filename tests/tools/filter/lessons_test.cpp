// SPDX-License-Identifier: MIT
// Filters learn from views, and from what is drawn of them.
#include "filter/lessons.h"

#include <catch2/catch.hpp>
#include <set>

#include "draw/draw_surface.h"
#include "metrics/metrics.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::filter
{

namespace
{

using tools::FieldFile;
namespace test = tools::test;

LessonSettings small_lessons(int views, const std::string& cache)
{
    LessonSettings settings;
    settings.views = views;
    settings.side_px = 32;
    settings.samples = 2;
    settings.cache = cache;
    return settings;
}

std::string write_surface(const test::TemporaryFolder& folder)
{
    test::write_content(folder / "s.lumi", test::small_surface_bytes());
    return folder / "s.lumi";
}

}  // namespace

TEST_CASE("views are dealt out in the proportions of the paper, each once, over the whole range of distances")
{
    const Views views = lesson_views(small_lessons(2619, ""), 1);
    CHECK(views.training.size() == 2220);
    CHECK(views.validation.size() == 204);
    CHECK(views.test.size() == 195);
    std::set<std::pair<double, double>> places;
    double below_middle = 0, upper = 0;
    for (const auto* part : {&views.training, &views.validation, &views.test})
        for (const auto& view : *part) {
            places.insert({view.azimuth_deg, view.elevation_deg});
            CHECK((view.distance >= 2.5 && view.distance < 4));
            below_middle += view.distance < 3.25;
            upper += view.elevation_deg > 0;
        }
    CHECK(places.size() == 2619);
    CHECK(below_middle / 2619 == Approx(0.5).margin(0.03));  // three standard deviations
    CHECK(upper / 2619 == Approx(0.5).margin(0.001));        // by construction
}

TEST_CASE("three views are one for each purpose, and a cap keeps views above it")
{
    const Views few = lesson_views(small_lessons(3, ""), 1);
    CHECK((few.training.size() == 1 && few.validation.size() == 1 && few.test.size() == 1));
    for (const auto& view : lesson_views(small_lessons(50, ""), 0.5).training) CHECK(view.elevation_deg > 0);
}

TEST_CASE("a drawn view over black and over grey is what render shows")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "c.lumi", test::field_bytes({}));
    test::write_content(folder / "g.lumi", test::glossy_surface_bytes());
    REQUIRE(gloss_count(FieldFile(folder / "g.lumi").surface()) != 0);
    for (const std::string& path : {write_surface(folder), folder / "c.lumi", folder / "g.lumi"}) {
        const FieldFile field(path);
        const tools::Eye eye = quality::view_at(40, 20, 3, 48).eye;
        const Planes planes = drawn_planes(field, eye);
        CHECK(planes.count == (field.is_surface() ? kSurfacePlanes : kPicturePlanes));
        for (const Rgb8& background : {Rgb8{0, 0, 0}, Rgb8{90, 120, 200}}) {
            tools::Picture shown;
            if (field.is_surface())
                shown = tools::draw_surface(field.surface(), eye, {SurfaceMode::two_by_two, {}, background});
            else {
                tools::DrawSettings settings;
                settings.background = background;
                shown = tools::draw(field.field(), eye.camera, settings);
            }
            CHECK(tools::psnr_db(over(planes, background), shown) > 55);  // less than a level: two roundings
        }
    }
}

TEST_CASE("a surface field's view has depths and colours where it is covered, and nothing elsewhere")
{
    const test::TemporaryFolder folder;
    const FieldFile field(write_surface(folder));
    const Planes planes = drawn_planes(field, quality::view_at(40, 20, 3, 64).eye);
    size_t whole = 0, without_depth = 0, beside = 0;
    for (size_t i = 0; i < planes.size(); ++i) {
        const uint8_t coverage = planes.plane(kCoveragePlane)[i], depth = planes.plane(kPicturePlanes + 3)[i];
        const uint8_t slope = planes.plane(kPicturePlanes + 4)[i];
        whole += coverage == 255;
        without_depth += coverage == 255 && (depth == 0 || slope == 0);
        beside += coverage == 0 && (depth != 0 || slope != 0);
    }
    CHECK(whole > planes.size() / 8);
    CHECK(without_depth == 0);
    CHECK(beside == 0);
}

TEST_CASE("references are traced once and kept")
{
    const test::TemporaryFolder folder;
    const FieldFile field(write_surface(folder));
    const LessonSettings settings = small_lessons(4, folder / "cache");
    uint64_t traced = 0;
    const auto count = [&](const baker::Progress& progress) {
        traced = std::max(traced, progress.rays_done);
        CHECK(progress.rays_total == 32 * 32 * (2 * 2 + 2 * 8));
        return true;
    };
    const Lessons first = lessons_of(field, test::cube_scene(), settings, count);
    CHECK(traced == 32 * 32 * (2 * 2 + 2 * 8));
    traced = 0;
    const Lessons again = lessons_of(field, test::cube_scene(), settings, count);
    CHECK(traced == 0);
    REQUIRE(first.training.size() == 2);
    CHECK((first.training[1].reference.values == again.training[1].reference.values));
    CHECK((first.test.drawn[0].values == again.test.drawn[0].values));
}

}  // namespace lumi::filter
