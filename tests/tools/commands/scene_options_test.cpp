// SPDX-License-Identifier: MIT
// The options that say how a scene is lit and how it stands.
#include <algorithm>
#include <catch2/catch.hpp>

#include "image/png.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

using test::lumi;
using test::Outcome;

namespace
{

Outcome reference(const std::string& picture, const test::Arguments& more)
{
    test::Arguments call = {"reference", LUMI_TEST_SCENE, "-o", picture, "--size", "24x24", "--spp", "16"};
    call.insert(call.end(), more.begin(), more.end());
    return lumi(call);
}

Picture lit_by(const std::string& environment, const std::string& background = "ff00ff")
{
    const test::TemporaryFolder folder;
    const Outcome outcome = reference(folder / "p.png", {"--environment", environment, "--background", background});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return read_png(folder / "p.png");
}

double mean_of(const Picture& picture, size_t channel)
{
    double sum = 0;
    for (size_t k = channel; k < picture.rgb.size(); k += 3) sum += picture.rgb[k];
    return sum / static_cast<double>(picture.rgb.size() / 3);
}

}  // namespace

TEST_CASE("environment: black leaves a scene without lamps black, before an untouched background")
{
    const Picture picture = lit_by("black");
    size_t black = 0, background = 0;
    for (size_t k = 0; k < picture.rgb.size(); k += 3) {
        black += picture.rgb[k] == 0 && picture.rgb[k + 2] == 0 ? 1u : 0u;
        background += picture.rgb[k] == 255 && picture.rgb[k + 2] == 255 ? 1u : 0u;
        CHECK(picture.rgb[k + 1] == 0);
    }
    CHECK(black > 50);
    CHECK(background > 50);
}

TEST_CASE("environment: --environment takes one number for grey, or a colour")
{
    CHECK(lit_by("0.4").rgb == lit_by("0.4,0.4,0.4").rgb);
    const Picture red = lit_by("0.8,0.1,0.1", "000000"), studio = lit_by("studio");
    CHECK(mean_of(red, 0) > 2 * mean_of(red, 2));
    CHECK(studio.rgb != red.rgb);
}

TEST_CASE("environment: --environment counts more than the scene file, which counts more than the studio")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "s.json",
                        std::string(R"({"objects": [{"obj": ")") + LUMI_TEST_SCENE + R"("}], "environment": 0.4})");
    const auto picture = [&](const test::Arguments& more) {
        test::Arguments call = {"reference", folder / "s.json", "-o", folder / "p.png", "--size",
                                "24x24",     "--spp",           "16", "--background",   "ff00ff"};
        call.insert(call.end(), more.begin(), more.end());
        REQUIRE(lumi(call).code == 0);
        return read_png(folder / "p.png").rgb;
    };
    CHECK(picture({}) == lit_by("0.4").rgb);
    CHECK(picture({"--environment", "0.7"}) == lit_by("0.7").rgb);
}

TEST_CASE("environment: one that cannot be is a wrong call that says what can")
{
    const test::TemporaryFolder folder;
    for (const char* word :
         {"", "red", "-1", "1,2", "1,2,3,4", "1,,2", "1,2,", "nan", "inf", "1e12", "0.5x", "studio,1"}) {
        INFO(word);
        const Outcome outcome = reference(folder / "p.png", {"--environment", word});
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.err, Catch::Contains("--environment") &&
                                    Catch::Contains("takes studio, black or a colour such as 0.8 or 1,0.9,0.7"));
    }
    CHECK(folder.entries() == 0);
}

TEST_CASE("footprint: --footprint says what a texel is the mean of")
{
    const test::TemporaryFolder folder;
    const auto baked = [&](const std::string& footprint) {
        const Outcome outcome = lumi({"bake", LUMI_TEST_SCENE, "-o", folder / "f.lumi", "--origins", "40",
                                      "--directions", "40", "--spp", "4", "--footprint", footprint});
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
        return test::content_of(folder / "f.lumi");
    };
    const std::string point = baked("point"), origin = baked("origin"), both = baked("both");
    CHECK(point != origin);
    CHECK(point != both);
    CHECK(origin != both);
    const Outcome outcome = lumi({"bake", LUMI_TEST_SCENE, "-o", folder / "f.lumi", "--footprint", "cell"});
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, Catch::Contains("point") && Catch::Contains("origin") && Catch::Contains("both"));
}

TEST_CASE("beam: --beam says how a texel's rays lie, and is refused where there is one ray")
{
    const test::TemporaryFolder folder;
    const auto bake = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"bake", LUMI_TEST_SCENE, "-o", folder / "f.lumi", "--origins", "40",
                                         "--directions", "40", "--spp", "4"});
        return lumi(options);
    };
    const auto baked = [&](const std::string& beam) {
        REQUIRE(bake({"--beam", beam}).code == 0);
        return test::content_of(folder / "f.lumi");
    };
    const std::string converging = baked("converging");
    CHECK(baked("parallel") != converging);
    REQUIRE(bake({}).code == 0);
    CHECK(test::content_of(folder / "f.lumi") == converging);
    const Outcome one_ray = bake({"--beam", "parallel", "--footprint", "point"});
    CHECK(one_ray.code == 2);
    CHECK_THAT(one_ray.err, Catch::Contains("--footprint point") && Catch::Contains("one ray"));
}

}  // namespace lumi::tools
