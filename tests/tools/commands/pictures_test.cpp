// SPDX-License-Identifier: MIT
// From a scene to pictures and figures, through the program alone.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "image/picture_file.h"
#include "metrics/metrics.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

using test::kScene;
using test::lumi;
using test::Outcome;

namespace
{

void bake_picture_field(const std::string& output, test::Arguments more)
{
    more.insert(more.begin(), {"bake", kScene, "-o", output});
    const test::Outcome outcome = done(lumi(more));
    CHECK_THAT(outcome.out, Catch::StartsWith(output) && Catch::Contains("\nRP2040: "));
}

void draw(test::Arguments call)
{
    done(lumi(std::move(call)));
}

Picture mirrored(const Picture& picture)
{
    Picture result = picture;
    for (int y = 0; y < picture.height_px; ++y)
        for (int x = 0; x < picture.width_px; ++x)
            std::copy_n(picture.pixel(picture.width_px - 1 - x, y), 3, result.pixel(x, y));
    return result;
}

Picture upside_down(const Picture& picture)
{
    Picture result = picture;
    for (int y = 0; y < picture.height_px; ++y)
        paste(
            [&] {
                Picture row(picture.width_px, 1);
                std::copy_n(picture.pixel(0, picture.height_px - 1 - y), row.rgb.size(), row.rgb.data());
                return row;
            }(),
            0, y, result);
    return result;
}

}  // namespace

TEST_CASE("render and reference show the same view, from wherever the eye is and whichever axis is up", "[statistics]")
{
    // A coarse field is blurred, but a mirrored, tilted or turned view would be much worse than that: by 2 dB at least.
    const test::TemporaryFolder folder;
    for (const std::string up : {"y", "z"}) {
        bake_picture_field(folder / "f.lumi", {"--origins", "600", "--directions", "1200", "--spp", "2", "--up", up});
        for (const std::string orbit : {"20,25,3", "130,-30,2", "250,60,6"}) {
            draw({"render", folder / "f.lumi", "-o", folder / "a.png", "--orbit", orbit, "--size", "64x64",
                  "--background", "black"});
            draw({"reference", kScene, "-o", folder / "b.png", "--orbit", orbit, "--size", "64x64", "--spp", "4",
                  "--up", up});
            const Picture a = read_png(folder / "a.png"), b = read_png(folder / "b.png");
            INFO("up " << up << ", orbit " << orbit << ": " << psnr_db(a, b) << " dB, mirrored "
                       << psnr_db(a, mirrored(b)) << ", upside down " << psnr_db(a, upside_down(b)));
            CHECK(psnr_db(a, b) > psnr_db(a, mirrored(b)) + 2);
            CHECK(psnr_db(a, b) > psnr_db(a, upside_down(b)) + 2);
        }
    }
}

TEST_CASE("render says where spans cannot draw a field, and draws it exactly")
{
    const test::TemporaryFolder folder;
    const std::string field = folder / "f.lumi", png = folder / "p.png";
    const auto warned = [&](const std::string& points, const std::string& span) {
        bake_picture_field(field, {"--origins", points, "--directions", points, "--spp", "1"});
        const Outcome outcome = lumi({"render", field, "-o", png, "--size", "16x16", "--span", span});
        CHECK(outcome.code == 0);
        return outcome.err.find("every pixel of this field is drawn exactly") != std::string::npos;
    };
    CHECK(warned("40", "16"));
    CHECK_FALSE(warned("40", "1"));
    CHECK_FALSE(warned("90", "16"));
}

TEST_CASE("turntables of render and reference are named alike")
{
    const test::TemporaryFolder folder;
    bake_picture_field(folder / "f.lumi", {"--origins", "30", "--directions", "40", "--spp", "1"});
    draw({"render", folder / "f.lumi", "-o", folder / "a.png", "--turntable", "3", "--size", "16x16"});
    draw({"reference", kScene, "-o", folder / "b.png", "--turntable", "3", "--size", "16x16", "--spp", "1"});
    for (const std::string name : {"000", "001", "002", "sheet"}) {
        CHECK(std::filesystem::exists(folder / ("a-" + name + ".png")));
        CHECK(std::filesystem::exists(folder / ("b-" + name + ".png")));
    }
    CHECK(folder.entries() == 9);
}

TEST_CASE("compare says that backgrounds differ")
{
    const test::TemporaryFolder folder;
    Picture framed(20, 20, {40, 40, 40});
    write_png(folder / "grey.png", framed);
    for (const int corner : {0, 19, 380, 399}) std::fill_n(&framed.rgb[static_cast<size_t>(3 * corner)], 3, uint8_t{0});
    write_png(folder / "black.png", framed);
    CHECK_THAT(lumi({"compare", folder / "grey.png", folder / "black.png"}).err,
               Catch::Contains("black.png has black corners") && Catch::Contains("--background black"));
    for (const char* name : {"grey.png", "black.png"})
        CHECK(lumi({"compare", folder / name, folder / name}).err.empty());
}

TEST_CASE("compare prints the promised JSON keys")
{
    const test::TemporaryFolder folder;
    write_png(folder / "a.png", Picture(20, 20, {100, 100, 100}));
    write_png(folder / "b.png", Picture(20, 20, {110, 110, 110}));
    const auto differ = nlohmann::json::parse(
        lumi({"compare", folder / "a.png", folder / "b.png", "--json", "--error-picture", folder / "e.png"}).out);
    CHECK(differ["psnr_db"].get<double>() == Approx(28.1308).margin(1e-3));
    CHECK(differ["ssim"].get<double>() < 1);
    CHECK(differ["cw_ssim"].get<double>() == Approx(1));
    CHECK(differ["identical"] == false);
    CHECK(read_png(folder / "e.png").pixel(3, 3)[0] == 40);
    const auto same = nlohmann::json::parse(lumi({"compare", folder / "a.png", folder / "a.png", "--json"}).out);
    CHECK(same["psnr_db"].is_null());
    CHECK(same["identical"] == true);
    CHECK_THAT(lumi({"compare", folder / "a.png", folder / "a.png"}).out, Catch::Contains("inf dB"));
}

TEST_CASE("compare looks inside a mask, and refuses one that fits nothing")
{
    const test::TemporaryFolder folder;
    const Picture a(20, 20, {100, 100, 100});
    Picture b = a, mask(20, 20);
    for (int x = 0; x < 20; ++x) {
        b.pixel(x, 2)[0] = 110;
        mask.pixel(x, 2)[1] = mask.pixel(x, 3)[1] = 200;
    }
    write_png(folder / "a.png", a);
    write_png(folder / "b.png", b);
    write_png(folder / "mask.png", mask);
    write_png(folder / "black.png", Picture(20, 20));
    write_png(folder / "small.png", Picture(19, 20, {255, 255, 255}));
    const auto masked = [&](const std::string& name) {
        return lumi({"compare", folder / "a.png", folder / "b.png", "--json", "--mask", folder / name});
    };
    const auto likeness = nlohmann::json::parse(masked("mask.png").out);
    // An error of 10 in one of six values inside, in one of sixty everywhere.
    CHECK(likeness["mask_psnr_db"].get<double>() == Approx(28.1308 + 10 * std::log10(6.0)).margin(1e-3));
    CHECK(likeness["psnr_db"].get<double>() == Approx(28.1308 + 10 * std::log10(60.0)).margin(1e-3));
    CHECK(likeness["mask_ssim"] == 1);  // both rows lie nearer to the border than half a window
    CHECK(likeness["flip"].get<double>() > 0);
    CHECK(masked("black.png").code == 1);
    CHECK(masked("small.png").code == 1);
}

}  // namespace lumi::tools
