// SPDX-License-Identifier: MIT
// Guided fields through the program.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "image/png.h"
#include "metrics/psnr.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

namespace
{

using test::lumi;

constexpr int kChart = 24;

void bake_guided(const std::string& field)
{
    const test::Outcome outcome = lumi({"bake", LUMI_TEST_SCENE, "-o", field, "--layout", "guided", "--origins", "64",
                                        "--chart", std::to_string(kChart), "--spp", "1"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
}

}  // namespace

TEST_CASE("render draws guided fields in every mode of theirs, by default the best")
{
    const test::TemporaryFolder folder;
    const std::string field = folder / "f.lumi";
    bake_guided(field);
    const auto drawn = [&](const test::Arguments& more) {
        test::Arguments call = {"render", field, "-o", folder / "o.png", "--size", "64x64"};
        call.insert(call.end(), more.begin(), more.end());
        const test::Outcome outcome = lumi(call);
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        return read_png(folder / "o.png");
    };
    const Picture best = drawn({});
    CHECK(drawn({"--mode", "linear"}).rgb == best.rgb);
    for (const std::string mode : {"nearest", "one-origin", "mean"}) CHECK(drawn({"--mode", mode}).rgb != best.rgb);
    CHECK(drawn({"--no-antialiasing"}).rgb != best.rgb);
    CHECK(psnr_db(drawn({"--twin"}), best) > 35);
    CHECK(psnr_db(drawn({"--pixel", "rgb565"}), best) > 35);
}

TEST_CASE("render refuses modes of the other kind of field")
{
    const test::TemporaryFolder folder;
    bake_guided(folder / "g.lumi");
    REQUIRE(
        lumi({"bake", LUMI_TEST_SCENE, "-o", folder / "c.lumi", "--origins", "48", "--directions", "64", "--spp", "1"})
            .code == 0);
    const auto code = [&](const std::string& field, const test::Arguments& more) {
        test::Arguments call = {"render", folder / field, "-o", folder / "o.png"};
        call.insert(call.end(), more.begin(), more.end());
        return lumi(call).code;
    };
    CHECK(code("g.lumi", {"--mode", "paper"}) == 2);
    CHECK(code("c.lumi", {"--mode", "one-origin"}) == 2);
    CHECK(code("c.lumi", {"--mode", "mean"}) == 2);
    CHECK(code("c.lumi", {"--twin"}) == 2);
}

TEST_CASE("texels in blocks are baked, named, drawn, and refused where they cannot tell what is missing")
{
    const test::TemporaryFolder folder;
    const std::string field = folder / "f.lumi";
    const test::Arguments bake = {"bake",    LUMI_TEST_SCENE,        "-o",    field, "--origins", "64",
                                  "--chart", std::to_string(kChart), "--spp", "1",   "--texels",  "vq8",
                                  "--layout"};
    const auto with = [](test::Arguments call, const std::string& layout) {
        call.push_back(layout);
        return lumi(call);
    };
    const test::Outcome baked = with(bake, "guided"), focus = with(bake, "focus");
    INFO(baked.err);
    REQUIRE(baked.code == 0);
    CHECK(focus.code == 1);
    CHECK_THAT(focus.err, Catch::Contains("choose 4 or 8 bits"));
    CHECK_THAT(lumi({"inspect", field, "--verify", "--json"}).out, Catch::Contains("\"vq8\""));
    for (const std::string mode : {"linear", "nearest", "one-origin", "mean"})
        CHECK(lumi({"render", field, "-o", folder / "o.png", "--size", "64x64", "--mode", mode}).code == 0);
}

TEST_CASE("inspect accounts for every byte of a guided field")
{
    const test::TemporaryFolder folder;
    bake_guided(folder / "g.lumi");
    const auto json = nlohmann::json::parse(lumi({"inspect", folder / "g.lumi", "--json", "--verify"}).out);
    CHECK(json["layout"] == "guided");
    CHECK(json["surface"] == "proxy");
    CHECK(json["origins"] == 64);
    CHECK(json["chart_size"] == kChart);
    CHECK(json["proxy_triangles"].get<int>() > 0);
    uint64_t sum = json["other_bytes"];
    for (const auto& section : json["sections"]) {
        sum += section["bytes"].get<uint64_t>();
        CHECK(section["intact"] == true);
    }
    CHECK(sum == json["bytes"].get<uint64_t>());
    const std::string text = lumi({"inspect", folder / "g.lumi"}).out;
    const std::string charts = std::to_string(kChart) + " grid points";
    for (const std::string& word :
         {std::string("guided"), std::string("triangles"), charts, std::string("PROX"), std::string("CHRT")})
        CHECK_THAT(text, Catch::Contains(word));
}

}  // namespace lumi::tools
