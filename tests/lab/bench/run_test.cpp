// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"

using lumi::tools::test::content_of;
using lumi::tools::test::Outcome;
using lumi::tools::test::TemporaryFolder;

// One core, one renderer, one span: the whole way from source to JSON, on a field that is baked at once.
TEST_CASE("lumi bench builds, runs and judges, and counts the same twice", "[bench]")
{
    const TemporaryFolder folder;
    const auto bench = [&](const std::string& json) {
        return lumi::tools::test::lumi(
            {"bench",  "--core", "m4",     "--mode",       "linear",        "--texel", "luma8",
             "--span", "0,8",    "--view", "generic,pole", "--origins",     "100",     "--directions",
             "130",    "--spp",  "1",      "--work",       folder / "work", "--json",  json});
    };
    const Outcome first = bench(folder / "a.json");
    INFO(first.err);
    REQUIRE(first.code == 0);
    REQUIRE(bench(folder / "b.json").code == 0);
    CHECK(content_of(folder / "a.json") == content_of(folder / "b.json"));

    const auto results = nlohmann::json::parse(content_of(folder / "a.json"));
    REQUIRE(results.size() == 4);  // two spans of two views
    for (const auto& result : results) {
        CHECK(result["covered_pixels"] == 42272);
        CHECK(result["instructions_per_pixel"].get<double>() > 10);
        CHECK(result["setup"].get<double>() > 0);
        CHECK(result["code_bytes"].get<uint32_t>() > 1000);
        CHECK(result["stack_bytes"].get<uint32_t>() > 100);
        CHECK(result["lines_rp2040"].get<uint64_t>() > 10);
        CHECK(result["misses_rp2040"].get<uint64_t>() >= result["lines_rp2040"].get<uint64_t>());
    }
    CHECK(results[0]["psnr_db"].get<double>() > 60);  // the exact renderer, within rounding
}

// The same of a surface field that the user names.
TEST_CASE("lumi bench counts a given surface field, part by part", "[bench]")
{
    const TemporaryFolder folder;
    lumi::tools::test::write_content(folder / "cube.lumi", lumi::tools::test::small_surface_bytes());
    const Outcome outcome = lumi::tools::test::lumi({"bench", "--core", "m0plus", "--field", folder / "cube.lumi",
                                                     "--pixel", "rgb565,rgb888", "--view", "generic", "--work",
                                                     folder / "work", "--json", folder / "a.json"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    const auto results = nlohmann::json::parse(content_of(folder / "a.json"));
    REQUIRE(results.size() == 6);  // three modes of two kinds of pixels
    for (const auto& result : results) {
        CHECK(result["layout"] == "surface");
        CHECK(result["covered_pixels"] == 42272);
        double sum = 0;
        for (const char* part : {"palette", "vertices", "lists", "lights", "edges", "samples", "outlines", "resolve"})
            sum += result[part].get<double>();
        CHECK(result["instructions_per_pixel"].get<double>() == Approx(sum).margin(0.1));
        CHECK(result["fps2_rp2040"].get<double>() > result["fps_rp2040"].get<double>());
        CHECK(result["file_bytes"] == lumi::tools::test::small_surface_bytes().size());
        CHECK(result["sha256"].get<std::string>().size() == 64);
    }
    CHECK(results[0]["ram_bytes"].get<uint32_t>() < results[2]["ram_bytes"].get<uint32_t>());
}
