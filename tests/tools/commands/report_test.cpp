// SPDX-License-Identifier: MIT
// `lumi report` through the program.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

TEST_CASE("report measures a field beside its baselines and writes page and JSON")
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
    CHECK_THAT(outcome.out, Catch::Contains("chord field") && Catch::Contains("one exact ray"));
    const auto report = nlohmann::json::parse(test::content_of(folder / "r.json"));
    CHECK(report["fields"][0]["layout"] == "chord");
    CHECK(report["fields"][0]["psnr_db"].get<double>() > 5);
    CHECK(report["one_ray"]["psnr_db"].get<double>() > report["fields"][0]["psnr_db"].get<double>());
    CHECK(report["baselines"].size() == 1);  // no room for a sprite
    CHECK_THAT(test::content_of(folder / "r.html"), Catch::StartsWith("<!DOCTYPE html>"));
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
