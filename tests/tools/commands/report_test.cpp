// SPDX-License-Identifier: MIT
// `lumi report` through the program.
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "image/picture_file.h"
#include "support/program.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

namespace
{

// A chord field of a cube, which spans draw; it is baked once.
const std::string& small_chord_bytes()
{
    static const std::string bytes = [] {
        const test::TemporaryFolder folder;
        const std::string field = folder / "c.lumi";
        REQUIRE(test::lumi({"bake", test::write_cube(folder.path()), "-o", field, "--origins", "70", "--directions",
                            "70", "--spp", "1"})
                    .code == 0);
        return test::content_of(field);
    }();
    return bytes;
}

}  // namespace

TEST_CASE("report measures a field and writes page and JSON")
{
    const test::TemporaryFolder folder;
    const std::string field = folder / "f.lumi";
    REQUIRE(test::lumi({"bake", LUMI_TEST_SCENE, "-o", field, "--origins", "60", "--directions", "60", "--spp", "1"})
                .code == 0);
    const test::Arguments call = {"report",  LUMI_TEST_SCENE,  field, "--count",        "1", "--spp", "1",
                                  "--cache", folder / "cache", "-o",  folder / "r.html"};
    const test::Outcome outcome = done(test::lumi(call));
    CHECK_THAT(outcome.out, Catch::Contains("frames a second"));
    CHECK_THAT(outcome.err, !Catch::Contains("its sphere"));
    test::Arguments other = call;
    other[1] = test::write_cube(folder.path());
    CHECK_THAT(done(test::lumi(other)).err, Catch::Contains("its sphere is not that of " + other[1]));
    test::Arguments for_machines = call;
    for_machines.push_back("--json");
    const auto report = nlohmann::json::parse(test::lumi(for_machines).out);
    CHECK(report["fields"][0]["layout"] == "chord");
    CHECK(report["fields"][0]["psnr_db"].get<double>() > 5);
    CHECK_THAT(test::content_of(folder / "r.html"), Catch::StartsWith("<!DOCTYPE html>"));
}

TEST_CASE("report --mode draws a chord field by every mode that is named, in views of --size")
{
    const test::TemporaryFolder folder;
    const std::string field = folder / "f.lumi", scene = test::write_cube(folder.path());
    test::write_content(field, small_chord_bytes());
    const auto report = [&](const std::string& modes) {
        return test::lumi({"report", scene, field, "--count", "1", "--spp", "1", "--size", "48", "--cache",
                           folder / "cache", "--json", "--mode", modes});
    };
    const test::Outcome outcome = done(report("nearest,linear,paper5,linear/8"));
    const auto written = nlohmann::json::parse(outcome.out);
    REQUIRE(written["variants"].size() == 4);
    CHECK(written["variants"][0]["layout"] == "nearest");
    CHECK(written["variants"][1]["psnr_db"] == written["fields"][0]["psnr_db"]);
    CHECK(written["variants"][2]["psnr_db"] != written["variants"][0]["psnr_db"]);
    CHECK(written["variants"][3]["layout"] == "linear/8");
    for (const char* wrong : {"paper0", "paper10", "cubic", "linear/3", "paper5/8", "linear/", "dither"})
        check_refused(report(wrong), 2, "paperK with K from 1 to 9");
}

namespace
{

// A chord field and a surface field of a cube, and a folder for what reports keep.
struct Fields {
    const test::TemporaryFolder folder;
    const std::string scene = test::write_cube(folder.path()), surface = folder / "s.lumi", chord = folder / "c.lumi";

    Fields()
    {
        test::write_content(surface, test::small_surface_bytes());
        test::write_content(chord, small_chord_bytes());
    }

    test::Outcome report(const test::Arguments& more) const
    {
        test::Arguments call = {"report", scene, surface,  chord, "--count", "1",
                                "--spp",  "1",   "--size", "64",  "--cache", folder / "cache"};
        call.insert(call.end(), more.begin(), more.end());
        return test::lumi(call);
    }
};

}  // namespace

TEST_CASE("report --for recommends for every part a row of its front, and names the command first")
{
    const Fields fields;
    const std::string page = fields.folder / "r.html";
    const test::Outcome outcome = done(fields.report({"--for", "rp2040,stm32h7@60fps", "--json", "-o", page}));
    const auto trade = nlohmann::json::parse(outcome.out)["trade"];
    const auto& rows = trade["rows"];
    REQUIRE(trade["parts"].size() == 2);
    CHECK(trade["parts"][0]["wanted"] == 10);
    CHECK(trade["parts"][1]["wanted"] == 60);
    for (const auto& part : trade["parts"]) {
        INFO(part);
        const std::string key = part["part"];
        REQUIRE(part["front"].size() > 0);
        const auto& best = rows[part["recommended"].get<size_t>()];
        CHECK(part["commands"][0].get<std::string>().find("lumi render") == 0);
        CHECK(best["parts"][key]["frames_per_second"].get<double>() >= part["wanted"].get<double>());
        for (const auto& row : rows) {
            INFO(row);
            // A more accurate row is slower than is wanted, and nothing beats a row of the front.
            if (row["psnr_db"].get<double>() > best["psnr_db"].get<double>() + 0.01)
                CHECK(row["parts"][key]["frames_per_second"].get<double>() < part["wanted"].get<double>());
            CHECK(row["parts"][key]["worst"] <= row["parts"][key]["frames_per_second"]);
            CHECK(row["ram_bytes"].get<uint64_t>() >= 240 * 16 * 2);
        }
    }
    const std::string html = test::content_of(page);
    CHECK(html.find("lumi render") < html.find("<img"));
    CHECK(html.find("<img") < html.find("<table"));
    CHECK_THAT(fields.report({"--for", "rp2040"}).out, Catch::StartsWith("RP2040 at 10"));
}

TEST_CASE("report --for without fields takes of its ladder what an earlier call has baked, and bakes the others")
{
    const Fields fields;
    const std::filesystem::path cache = fields.folder / "cache";
    REQUIRE(fields.report({"--for", "rp2040"}).code == 0);  // makes the folder of the scene
    const std::filesystem::path kept = *std::filesystem::directory_iterator(cache);
    std::filesystem::copy(fields.surface, kept / "surface-120kB-12paths.lumi");
    const std::string foreign = test::content_of(fields.chord);
    test::write_content(kept / "surface-250kB-12paths.lumi", foreign);
    std::filesystem::copy(fields.surface, kept / "surface-500kB-12paths.lumi");
    std::filesystem::copy(fields.chord, kept / "chord-1MB-4paths.lumi");
    const test::Outcome outcome =
        done(test::lumi({"report", fields.scene, "--quick", "--count", "1", "--spp", "1", "--for", "rp2040", "--json",
                         "--cache", cache.string(), "--up", "y"}));
    const auto report = nlohmann::json::parse(outcome.out);
    CHECK(report["fields"].size() == 4);
    const std::string command = report["trade"]["parts"][0]["commands"][0];
    CHECK_THAT(command,
               Catch::StartsWith("lumi bake ") && Catch::Contains(" --up y --layout ") && Catch::Contains(" --fit "));
    CHECK((test::content_of(kept / "surface-120kB-12paths.lumi") == test::content_of(fields.surface)));
    CHECK((test::content_of(kept / "surface-250kB-12paths.lumi") != foreign));
    CHECK((test::content_of(kept / "chord-1MB-4paths.lumi") == foreign));
}

namespace
{

// When each file of the folder was written, by name.
std::map<std::string, std::filesystem::file_time_type> times_of(const std::filesystem::path& folder)
{
    std::map<std::string, std::filesystem::file_time_type> times;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder))
        if (file.is_regular_file()) times[file.path().string()] = file.last_write_time();
    return times;
}

}  // namespace

TEST_CASE("a second report traces no reference again, and traces anew what is damaged")
{
    const Fields fields;
    const std::filesystem::path cache = fields.folder / "cache";
    const test::Arguments call = {"--json"};
    const auto figures = [&] {
        const test::Outcome outcome = done(fields.report(call));
        nlohmann::json fields_of_report = nlohmann::json::parse(outcome.out)["fields"];
        for (nlohmann::json& field : fields_of_report) field.erase("draw_ms");
        return fields_of_report;
    };
    const auto whole = figures();

    const auto written = times_of(cache);
    CHECK(figures() == whole);
    CHECK(times_of(cache) == written);
    // Pictures of other sizes: larger, smaller, and smaller than the windows of the measures.
    for (const int side : {61, 20, 4}) {
        INFO(side);
        for (const auto& [path, time] : written) tools::write_png(path, tools::Picture(side, side));
        CHECK(figures() == whole);
    }
    for (const auto& [path, time] : written) test::write_content(path, "junk");
    CHECK(figures() == whole);
}

TEST_CASE("a report measures another field under the same name anew")
{
    const Fields fields;
    const test::Arguments call = {"--for", "rp2040", "--json"};
    const auto before = nlohmann::json::parse(fields.report(call).out);
    REQUIRE(
        test::lumi({"bake", fields.scene, "-o", fields.chord, "--origins", "200", "--directions", "300", "--spp", "1"})
            .code == 0);
    const auto after = nlohmann::json::parse(fields.report(call).out);
    REQUIRE(before["fields"].size() == 2);
    CHECK(after["fields"][0]["psnr_db"] == before["fields"][0]["psnr_db"]);
    CHECK(after["fields"][1]["psnr_db"] != before["fields"][1]["psnr_db"]);
}

TEST_CASE("report without fields and without parts says what it takes")
{
    check_refused(test::lumi({"report", LUMI_TEST_SCENE}), 2, "--for with parts");
}

TEST_CASE("report --for refuses what is no part, with the list of parts")
{
    const test::TemporaryFolder folder;
    for (const char* wrong : {"z80", "rp2040@", "rp2040@0fps", "rp2040,z80@10fps"}) {
        check_refused(test::lumi({"report", LUMI_TEST_SCENE, folder / "f.lumi", "--for", wrong}), 2,
                      "rp2040, rp2350, stm32f4, stm32h7, esp32s3, nrf52840, stm32u5 or esp32c3");
    }
}

TEST_CASE("report refuses what is not a field before it traces anything")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", "no field");
    check_refused(
        test::lumi({"report", LUMI_TEST_SCENE, folder / "f.lumi", "--cache", folder / "cache", "--spp", "1000000"}), 1,
        "f.lumi");
}

}  // namespace lumi::tools
