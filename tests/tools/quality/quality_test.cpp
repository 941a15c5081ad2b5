// SPDX-License-Identifier: MIT
// The measuring half of `lumi report`.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "lumi/baker/chord.h"
#include "lumi/detail/lattice.h"
#include "lumi/twin/geometry.h"
#include "quality/page.h"
#include "quality/report_data.h"
#include "support/temporary_folder.h"

namespace lumi::quality
{

namespace
{

using tools::test::TemporaryFolder;

baker::Scene test_scene()
{
    std::vector<std::string> warnings;
    return baker::load_scene(LUMI_TEST_SCENE, {}, warnings);
}

size_t count_of(const std::string& text, const std::string& part)
{
    size_t count = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

Measured some_field(const std::string& name, uint64_t bytes, const std::vector<Reference>& references)
{
    Measured m;
    m.name = name;
    m.layout = "surface";
    m.flash_bytes = bytes;
    m.sections = {{"SURF", true, 64, 32, 0}, {"SPAT", true, 96, 400, 0}};
    for (const Reference& reference : references) {
        m.pictures.push_back(reference.picture);
        m.figures.push_back(figures_of(reference.picture, reference));
    }
    m.mean = mean_of(m.figures);
    return m;
}

}  // namespace

TEST_CASE("held-out views lie where they should, all around the sphere")
{
    const auto views = held_out_views(ViewSet::all, 12);
    REQUIRE(views.size() == 12);
    twin::Vec3 sum = {0, 0, 0};
    std::set<double> distances;
    for (const HeldOutView& view : views) {
        CHECK(view.distance >= 2.5);
        CHECK(view.distance <= 4);
        distances.insert(view.distance);
        const twin::Vec3 eye = twin::decoded(view.eye.pose.eye);
        CHECK(twin::length(eye) == Approx(view.distance).margin(1e-4));
        sum = sum + twin::normalised(eye);
    }
    CHECK(twin::length((1.0 / 12) * sum) < 0.1);
    CHECK(distances.size() == 12);
    for (const HeldOutView& view : held_out_views(ViewSet::upper, 12)) CHECK(view.elevation_deg > 0);
}

TEST_CASE("held-out views look from no origin of a field")
{
    for (const uint32_t origins : {64u, 128u, 256u}) {
        const auto points = twin::points(origins);
        for (const HeldOutView& view : held_out_views(ViewSet::all)) {
            const twin::Vec3 direction = twin::normalised(twin::decoded(view.eye.pose.eye));
            for (const twin::Vec3& p : points) CHECK(twin::length(p - direction) > 0.05 * twin::spacing(origins));
        }
    }
}

TEST_CASE("figures of a picture that is its reference are finite and best")
{
    const Reference reference = {tools::Picture(24, 20, {9, 80, 200}), {24, 20}};
    const Figures figures = figures_of(reference.picture, reference);
    CHECK(figures.psnr_db == kIdenticalDb);
    CHECK(figures.mask_psnr_db == kIdenticalDb);  // an empty mask: the whole picture
    CHECK(figures.ssim == Approx(1));
    CHECK(figures.flip == Approx(0).margin(1e-9));
    const Figures mean = mean_of({figures, {}});
    CHECK(mean.psnr_db == Approx(kIdenticalDb / 2));
    CHECK(mean.mask_ssim == Approx(0.5));
}

TEST_CASE("references are traced once and then read from their folder")
{
    const TemporaryFolder folder;
    const baker::Scene scene = test_scene();
    const auto views = held_out_views(ViewSet::all, 2, 32);
    const baker::ReferenceSettings settings = {2, 1, 1};
    const auto first = references_of(scene, views, settings, folder.path());
    REQUIRE(first.size() == 2);
    CHECK(std::any_of(first[0].mask.values.begin(), first[0].mask.values.end(), [](uint8_t m) { return m != 0; }));
    bool traced = false;
    const auto notice = [&](const baker::Progress&) { return traced = true; };
    const auto again = references_of(scene, views, settings, folder.path(), notice);
    CHECK_FALSE(traced);
    CHECK(again[1].picture.rgb == first[1].picture.rgb);
    CHECK(again[1].mask.values == first[1].mask.values);
    references_of(scene, views, {3, 1, 1}, folder.path(), notice);
    CHECK(traced);
}

TEST_CASE("the worst view is named from 1 on")
{
    Measured m;
    for (const double db : {33.0, 30.25, 31.0}) m.figures.push_back({db, 0, 0, 0, 0, 0});
    CHECK(worst_view_text(m) == "30.2 (2)");
}

TEST_CASE("base64 is that of RFC 4648, section 10")
{
    CHECK(base64("").empty());
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64("\xFF\xFE") == "//4=");
}

TEST_CASE("the page holds every picture and asks the network for nothing")
{
    const TemporaryFolder folder;
    ReportData report;
    report.scene = "a <b> & \"c\".obj";
    report.views = held_out_views(ViewSet::all, 2, 24);
    for (uint8_t grey : {uint8_t{40}, uint8_t{90}})
        report.references.push_back({tools::Picture(24, 24, {grey, grey, grey}), {24, 24}});
    report.fields = {some_field("x/small.lumi", 250000, report.references),
                     some_field("x/large.lumi", 500000, report.references)};
    const std::string page = page_of(report);
    CHECK(count_of(page, "<img ") == 2 * (1 + 2 * 2));  // the reference, and a picture and its error a field
    CHECK(count_of(page, "data:image/png;base64,") == count_of(page, "<img "));
    CHECK(count_of(page, "src=\"") == count_of(page, "src=\"data:"));
    for (const char* external : {"href=", "<script", "@import", "url("}) CHECK(count_of(page, external) == 0);
    CHECK(count_of(page, "http") == 0);
    CHECK_THAT(page, Catch::Contains("a &lt;b&gt; &amp; &quot;c&quot;.obj"));
    CHECK_THAT(page, Catch::Contains("width=device-width"));
    CHECK_THAT(page, Catch::Contains(">patch 400 bytes<"));
}

TEST_CASE("the report for programs has the promised keys")
{
    ReportData report;
    report.scene = "s.obj";
    report.views = held_out_views(ViewSet::upper, 1, 24);
    report.set = ViewSet::upper;
    report.references = {{tools::Picture(24, 24), {24, 24}}};
    report.fields = {some_field("f.lumi", 250000, report.references)};
    const auto json = nlohmann::json::parse(json_of(report));
    CHECK(json["view_set"] == "upper");
    CHECK(json["views"].size() == 1);
    const auto& field = json["fields"][0];
    for (const char* key : {"psnr_db", "ssim", "cw_ssim", "flip", "mask_psnr_db", "mask_ssim"}) {
        CHECK(field[key].is_number());
        CHECK(field["views"][0][key].is_number());
    }
    CHECK(field["flash_bytes"] == 250000);
    CHECK(field["sections"]["SPAT"] == 400);
}

}  // namespace lumi::quality
