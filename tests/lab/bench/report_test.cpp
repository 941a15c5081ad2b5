// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "bench/boards.h"
#include "bench/report.h"
#include "bench/svg.h"
#include "terminal/failure.h"

using namespace lumi::bench;

namespace
{

const std::string kLine = "view pole span 8 covered 1000 instructions 123456 setup 23456 stack 640 crc 0badcafe\n";

const std::string kSurfaceLine =
    "view generic mode 2x2 covered 1000 instructions 100000 palette 100 vertices 9900 lists 10000 lights 20000 edges "
    "30000 samples 20000 outlines 4000 resolve 6000 stack 640 ram 48000 crc 0badcafe\n";

// On the cores of RP2350, which has two.
SurfaceResults some_surface()
{
    SurfaceResult result;
    result.core = "m4";
    result.pixel = "rgb565";
    result.count = parse_surface_counts(kSurfaceLine).front();
    result.accuracy = {INFINITY, INFINITY, 0};
    return {{"a.lumi", 12345, 60, 50, 80, "0123"}, {result}};
}

std::set<std::string> keys_of(const nlohmann::json& result)
{
    std::set<std::string> keys;
    for (const auto& [key, value] : result.items()) keys.insert(key);
    return keys;
}

Result some_result()
{
    Result result;
    result.core = "m4";
    result.mode = "linear";
    result.texel = "luma8";
    result.count = parse_counts(kLine).front();
    result.accuracy = {INFINITY, 41.239, 7};
    return result;
}

}  // namespace

TEST_CASE("the bench reads what its firmware writes, and nothing else", "[bench]")
{
    const auto counts = parse_counts(kLine + kLine);
    REQUIRE(counts.size() == 2);
    CHECK(counts[1].view == "pole");
    CHECK(counts[1].span == 8);
    CHECK(counts[1].instructions == 123456);
    CHECK(counts[1].crc == 0x0badcafe);
    CHECK_THROWS_AS(parse_counts("error: truncated\n"), lumi::tools::Failure);
    CHECK_THROWS_AS(parse_counts(kLine.substr(0, kLine.size() / 2)), lumi::tools::Failure);
    CHECK_THROWS_AS(parse_counts("view pole span 8 covered 9 instructions 0 setup 0 stack 0 crc 0\n"),
                    lumi::tools::Failure);
}

TEST_CASE("the bench reads parts of surface frames, and nothing else", "[bench]")
{
    const auto counts = parse_surface_counts(kSurfaceLine + kSurfaceLine);
    REQUIRE(counts.size() == 2);
    const SurfaceCount& c = counts[1];
    CHECK(c.mode == "2x2");
    CHECK(c.palette + c.vertices + c.lists + c.lights + c.edges + c.samples + c.outlines + c.resolve == c.instructions);
    CHECK(c.preparing() == 40000);
    CHECK(c.ram_bytes == 48000);
    CHECK_THROWS_AS(parse_surface_counts(kLine), lumi::tools::Failure);
    CHECK_THROWS_AS(parse_surface_counts(kSurfaceLine.substr(0, kSurfaceLine.size() - 30)), lumi::tools::Failure);
}

TEST_CASE("a surface field's result in JSON has the documented keys", "[bench]")
{
    const auto results = nlohmann::json::parse(json_report({some_result()}, some_surface()));
    REQUIRE(results.size() == 2);
    CHECK(results[0]["layout"] == "chord");
    std::set<std::string> expected = {"layout",        "core",
                                      "mode",          "pixel",
                                      "view",          "instructions_per_pixel",
                                      "palette",       "vertices",
                                      "lists",         "lights",
                                      "edges",         "samples",
                                      "outlines",      "resolve",
                                      "psnr_db",       "code_bytes",
                                      "ram_bytes",     "stack_bytes",
                                      "triangles",     "instructions_per_frame",
                                      "sha256",        "file",
                                      "file_bytes",    "worst_pixel",
                                      "covered_pixels"};
    for (const Chip& chip : kChipList) {
        expected.insert(std::string("misses_") + chip.key);
        if (std::string(chip.core) == "m4") expected.insert(std::string("fps_") + chip.key);
        if (std::string(chip.core) == "m4" && chip.cores == 2) expected.insert(std::string("fps2_") + chip.key);
    }
    CHECK(keys_of(results[1]) == expected);
    CHECK(results[1]["layout"] == "surface");
    CHECK(results[1]["mode"] == "2x2");
    CHECK(results[1]["instructions_per_pixel"] == Approx(100));
    CHECK(results[1]["edges"] == Approx(30));
    CHECK(results[1]["triangles"] == 80);
    CHECK(results[1]["psnr_db"].is_null());
}

TEST_CASE("a result in JSON has the documented keys and adds up", "[bench]")
{
    const auto results = nlohmann::json::parse(json_report({some_result()}, {}));
    REQUIRE(results.size() == 1);
    std::set<std::string> expected = {"layout",
                                      "core",
                                      "mode",
                                      "texel",
                                      "span",
                                      "view",
                                      "setup",
                                      "inner",
                                      "code_bytes",
                                      "stack_bytes",
                                      "psnr_db",
                                      "psnr_all_db",
                                      "worst_pixel",
                                      "covered_pixels",
                                      "instructions_per_pixel",
                                      "instructions_per_frame"};
    for (const Chip& chip : kChipList) {
        expected.insert(std::string("lines_") + chip.key);
        expected.insert(std::string("misses_") + chip.key);
    }
    CHECK(keys_of(results[0]) == expected);
    CHECK(results[0]["instructions_per_pixel"] == Approx(123.46));
    CHECK(results[0]["setup"] == Approx(23.46));
    CHECK(results[0]["inner"] == Approx(100.0));
    CHECK(results[0]["psnr_db"].is_null());
    CHECK(results[0]["psnr_all_db"] == Approx(41.24));
}

TEST_CASE("the slower of drawing and sending limits the frame rate", "[bench]")
{
    const Chip chip = {"x", "X", "m4", 100, 2.0, {64, 2, 8}, 500, ""};
    CHECK(frames_per_second(chip, 0, 0) == Approx(67.8).epsilon(0.001));
    CHECK(frames_per_second(chip, 5'000'000, 0) == Approx(10));       // 10 M clocks at 100 MHz
    CHECK(frames_per_second(chip, 5'000'000, 200'000) == Approx(5));  // and as long again in flash
}

TEST_CASE("two cores share what comes after the preparing, and wait for flash as long as one", "[bench]")
{
    const Chip chip = {"x", "X", "m4", 100, 2.0, {64, 2, 8}, 500, "", 2};
    CHECK(frames_per_second_of_two(chip, 0, 10'000'000, 0) == Approx(10));
    CHECK(frames_per_second_of_two(chip, 5'000'000, 15'000'000, 0) == Approx(5));
    CHECK(frames_per_second_of_two(chip, 0, 10'000'000, 200'000) == Approx(5));
}

TEST_CASE("a plot leaves out what has no place on it", "[bench]")
{
    const Plot plot = {"t", "x", "y", {{"a", {{10, 40, "one"}, {100, INFINITY, "two"}, {1000, 50, "three"}}}}};
    const std::string svg = svg_of(plot);
    CHECK(svg.find("one") != std::string::npos);
    CHECK(svg.find("two") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
    CHECK(svg_of({"t", "x", "y", {}}).find("nan") == std::string::npos);
}

TEST_CASE("a narrow plot puts its legend below, and marks a short axis densely", "[bench]")
{
    Plot plot = {"", "x", "y", {{"first", {{600, 40, ""}, {900, 41, ""}}}, {"second", {{600, 42, ""}}}}, true};
    const std::string svg = svg_of(plot);
    CHECK(svg.find("viewBox=\"0 0 440.0 384.0\"") != std::string::npos);  // the grid, and a row for each series
    for (const char* mark : {">600<", ">700<", ">800<", ">900<"}) CHECK(svg.find(mark) != std::string::npos);
    plot.series[0].points[0].x = 60;  // more than half a decade
    CHECK(svg_of(plot).find(">200<") != std::string::npos);
    CHECK(svg_of(plot).find(">700<") == std::string::npos);
}
