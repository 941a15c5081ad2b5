// SPDX-License-Identifier: MIT
// `lumi report` through the program.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

TEST_CASE("report measures a field and writes page and JSON")
{
    const test::TemporaryFolder folder;
    const std::string field = folder / "f.lumi";
    REQUIRE(test::lumi({"bake", LUMI_TEST_SCENE, "-o", field, "--origins", "60", "--directions", "60", "--spp", "1"})
                .code == 0);
    const test::Arguments call = {"report",  LUMI_TEST_SCENE,  field,    "--count",         "1",  "--spp",          "1",
                                  "--cache", folder / "cache", "--json", folder / "r.json", "-o", folder / "r.html"};
    const test::Outcome outcome = test::lumi(call);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK_THAT(outcome.out, Catch::Contains("frames a second"));
    const auto report = nlohmann::json::parse(test::content_of(folder / "r.json"));
    CHECK(report["fields"][0]["layout"] == "chord");
    CHECK(report["fields"][0]["psnr_db"].get<double>() > 5);
    CHECK_THAT(test::content_of(folder / "r.html"), Catch::StartsWith("<!DOCTYPE html>"));
}

TEST_CASE("report --mode draws a chord field by every mode that is named, in views of --size")
{
    const test::TemporaryFolder folder;
    const std::string field = folder / "f.lumi";
    REQUIRE(test::lumi({"bake", LUMI_TEST_SCENE, "-o", field, "--origins", "70", "--directions", "70", "--spp", "1"})
                .code == 0);
    const auto report = [&](const std::string& modes) {
        return test::lumi({"report", LUMI_TEST_SCENE, field, "--count", "1", "--spp", "1", "--size", "48", "--cache",
                           folder / "cache", "--json", folder / "r.json", "--mode", modes});
    };
    const test::Outcome outcome = report("nearest,linear,paper5,paper5/8");
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const auto written = nlohmann::json::parse(test::content_of(folder / "r.json"));
    REQUIRE(written["variants"].size() == 4);
    CHECK(written["variants"][0]["layout"] == "nearest");
    CHECK(written["variants"][1]["psnr_db"] == written["fields"][0]["psnr_db"]);
    CHECK(written["variants"][2]["psnr_db"] != written["variants"][0]["psnr_db"]);
    CHECK(written["variants"][3]["layout"] == "paper5/8");
    for (const char* wrong : {"paper0", "paper10", "cubic", "paper5/3", "linear/", "dither"}) {
        const test::Outcome refused = report(wrong);
        INFO(wrong << refused.err);
        CHECK(refused.code == 2);
        CHECK_THAT(refused.err, Catch::Contains("paperK with K from 1 to 9"));
    }
}

TEST_CASE("report refuses what is not a field before it traces anything")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", "no field");
    const test::Outcome outcome =
        test::lumi({"report", LUMI_TEST_SCENE, folder / "f.lumi", "--cache", folder / "cache", "--spp", "1000000"});
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.err, Catch::Contains("f.lumi"));
}

}  // namespace lumi::tools
