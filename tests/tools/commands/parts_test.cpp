// SPDX-License-Identifier: MIT
// Parts that move, through the program.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "image/picture_file.h"
#include "metrics/metrics.h"
#include "support/program.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::tools
{
namespace
{

using test::check_told;
using test::joined;
using test::lumi;

// A plate, and before it a bar that points to the right, both in planes x = const: azimuth 0 looks at them.
std::string write_gauge(const test::TemporaryFolder& folder)
{
    test::write_content(folder / "gauge.mtl", "newmtl white\nKd 0.8 0.8 0.8\nnewmtl red\nKd 0.8 0.05 0.05\n");
    const std::string obj = folder / "gauge.obj";
    test::write_content(obj,
                        "mtllib gauge.mtl\no plate\nusemtl white\nv 0 -1 -1\nv 0 1 -1\nv 0 1 1\nv 0 -1 1\nf 1 2 3 4\n"
                        "o a=b:needle\nusemtl red\nv 0.2 -0.1 -0.15\nv 0.2 0.9 -0.15\nv 0.2 0.9 0.15\nv 0.2 -0.1 0.15\n"
                        "f 5 6 7 8\n");
    return obj;
}

const test::Arguments kNeedle = {"--up", "z", "--part", "a=b:needle:x@0,0,0"};

Picture drawn(const test::Arguments& arguments, const std::string& output)
{
    done(lumi(joined(arguments, {"-o", output, "--size", "64x64", "--orbit", "0,0,3", "--background", "black"})));
    return read_png(output);
}

// The report of the gauge without fields, of which an earlier call has baked `field`.
nlohmann::json ladder_report(const test::TemporaryFolder& folder, const std::string& field)
{
    const std::string cache = folder / "cache", part = "a=b:needle:x@0,0,0";
    const test::Arguments report = {"report",  folder / "gauge.obj",
                                    "--up",    "z",
                                    "--sky",   "0.8",
                                    "--quick", "--json",
                                    "--count", "1",
                                    "--spp",   "4",
                                    "--size",  "48",
                                    "--cache", cache};
    done(lumi(joined(report, {field, "--part", part})));
    const std::filesystem::path kept = *std::filesystem::directory_iterator(cache);
    for (const std::string size : {"120kB", "250kB", "500kB"})
        std::filesystem::copy(field, kept / ("surface-" + size + "-12paths.lumi"));
    return nlohmann::json::parse(done(lumi(joined(report, {"--for", "rp2040", "--part", part + "=90"}))).out);
}

}  // namespace

TEST_CASE("parts: a field shows the pose that the reference of the scene has, whatever its name holds")
{
    const test::TemporaryFolder folder;
    const std::string scene = write_gauge(folder), field = folder / "gauge.lumi";
    done(lumi(
        joined(joined({"bake", scene, "-o", field}, kNeedle), {"--fit", "60kB", "--paths", "20", "--sky", "0.8"})));
    Picture rest;
    for (const std::string pose : {"0", "90", "-135", "540"}) {
        const Picture field_picture = drawn({"render", field, "--part", "a=b:needle=" + pose}, folder / "f.png");
        const Picture truth = drawn(
            {"reference", scene, "--up", "z", "--sky", "0.8", "--spp", "16", "--part", "a=b:needle:x@0,0,0=" + pose},
            folder / "r.png");
        INFO(pose);
        CHECK(psnr_db(field_picture, truth) > 24);
        if (pose == "0") rest = field_picture;
        CHECK((pose == "0") == (psnr_db(field_picture, rest) > 40));
    }
    const std::string parts = R"("parts": [{"name": "a=b:needle", "turn": "x", "pivot": [0, 0, 0]}])";
    test::write_content(folder / "gauge.json", R"({"objects": [{"obj": "gauge.obj"}], )" + parts + "}");
    const auto traced = [&](const std::string& file, const std::string& part) {
        return drawn({"reference", folder / file, "--up", "z", "--sky", "0.8", "--spp", "4", "--part", part},
                     folder / "r.png");
    };
    CHECK(psnr_db(traced("gauge.json", "a=b:needle=30"), traced("gauge.obj", "a=b:needle:x@0,0,0=30")) > 40);
    const nlohmann::json report = ladder_report(folder, field);
    REQUIRE(report["fields"].size() == 3);
    CHECK(report["fields"][0]["psnr_db"].get<double>() > 24);
    CHECK_THAT(report["trade"]["parts"][0]["commands"][0].get<std::string>(),
               Catch::Contains(" --up z --sky 0.8 --part a=b:needle:x@0,0,0 --layout surface --fit "));
    REQUIRE(lumi({"embed", field, "-o", folder / "gauge.S"}).code == 0);
    CHECK_THAT(test::content_of(folder / "gauge.h"),
               Catch::Contains("gauge_moving_parts = 2, gauge_part_a_b_needle = 0 }"));  // with its shadow
    check_told({"render", field, "-o", folder / "n.png", "--part", "a=b:neddle=1"},
               "named 'a=b:neddle' (did you mean a=b:needle?); choose among: a=b:needle");
    check_told({"render", field, "-o", folder / "n.png", "--part", "a=b:needle"}, "takes NAME=DEGREES");
    check_told({"render", field, "-o", folder / "n.png", "--part", "a=b:needle=0..9"}, "views of --turntable");
    const auto view = [&](const std::string& name, const test::Arguments& arguments) {
        REQUIRE(lumi(joined({"render", field, "-o", folder / name, "--size", "64x64"}, arguments)).code == 0);
    };
    view("t.png", {"--orbit", "0,5,3", "--part", "a=b:needle=-20..200", "--turntable", "4"});
    view("s.png", {"--orbit", "270,5,3", "--part", "a=b:needle=145"});
    CHECK(test::content_of(folder / "t-003.png") == test::content_of(folder / "s.png"));
}

TEST_CASE("parts: words that name no part are refused with the way to write it")
{
    const test::TemporaryFolder folder;
    const std::string scene = write_gauge(folder);
    const auto bake = [&](const std::string& part) {
        return test::Arguments{"bake", scene, "-o", folder / "n.lumi", "--part", part};
    };
    check_told(bake("needle"), "takes NAME:AXIS or NAME:AXIS@X,Y,Z");
    check_told(bake(":x"), "takes NAME:AXIS or NAME:AXIS@X,Y,Z");
    check_told(bake("a=b:needle:w"), "takes an axis x, y, z");
    check_told(bake("a=b:needle:1,2"), "takes an axis x, y, z");
    check_told(bake("a=b:needle:x@1,2"), "takes a pivot X,Y,Z");
    check_told(bake("a=b:needle:x"), "has no pivot");
    check_told(joined(joined({"bake", scene, "-o", folder / "n.lumi"}, kNeedle), {"--layout", "chord"}),
               "a chord field has no parts that move");
    test::write_content(folder / "s.lumi", test::small_surface_bytes());
    check_told({"render", folder / "s.lumi", "-o", folder / "n.png", "--part", "a=1"}, "nothing in it moves");
}

}  // namespace lumi::tools
