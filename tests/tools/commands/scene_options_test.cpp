// SPDX-License-Identifier: MIT
// The options that say how a scene is lit and how it stands.
#include <catch2/catch.hpp>

#include "image/picture_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

using test::joined;
using test::lumi;
using test::Outcome;

namespace
{

Outcome reference(const std::string& picture, const test::Arguments& more)
{
    return lumi(joined({"reference", LUMI_TEST_SCENE, "-o", picture, "--size", "24x24", "--spp", "16"}, more));
}

Picture lit_by(const std::string& environment, const std::string& background = "ff00ff")
{
    const test::TemporaryFolder folder;
    done(reference(folder / "p.png", {"--sky", environment, "--background", background}));
    return read_png(folder / "p.png");
}

double mean_of(const Picture& picture, size_t channel)
{
    double sum = 0;
    for (size_t k = channel; k < picture.rgb.size(); k += 3) sum += picture.rgb[k];
    return sum / static_cast<double>(picture.rgb.size() / 3);
}

}  // namespace

TEST_CASE("sky: black leaves a scene without lamps black, before an untouched background")
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

TEST_CASE("sky: --sky takes one number for grey, or a colour")
{
    CHECK(lit_by("0.4").rgb == lit_by("0.4,0.4,0.4").rgb);
    const Picture red = lit_by("0.8,0.1,0.1", "000000"), studio = lit_by("studio");
    CHECK(mean_of(red, 0) > 2 * mean_of(red, 2));
    CHECK(studio.rgb != red.rgb);
}

TEST_CASE("sky: --sky counts more than the scene file, which counts more than the studio")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "s.json",
                        std::string(R"({"objects": [{"obj": ")") + LUMI_TEST_SCENE + R"("}], "environment": 0.4})");
    const auto picture = [&](const test::Arguments& more) {
        REQUIRE(lumi(joined({"reference", folder / "s.json", "-o", folder / "p.png", "--size", "24x24", "--spp", "16",
                             "--background", "ff00ff"},
                            more))
                    .code == 0);
        return read_png(folder / "p.png").rgb;
    };
    CHECK(picture({}) == lit_by("0.4").rgb);
    CHECK(picture({"--sky", "0.7"}) == lit_by("0.7").rgb);
}

TEST_CASE("sky: named ones turn, by the option as in a scene file, and nobody asks for their exposure")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "s.json", std::string(R"({"objects": [{"obj": ")") + LUMI_TEST_SCENE +
                                               R"("}], "environment": {"sky": "evening", "rotate": 90}})");
    const Outcome outcome = done(lumi({"reference", folder / "s.json", "-o", folder / "p.png", "--size", "24x24",
                                       "--spp", "16", "--background", "ff00ff"}));
    CHECK_THAT(outcome.err, !Catch::Contains("exposure"));
    CHECK(read_png(folder / "p.png").rgb == lit_by("evening@90").rgb);
    CHECK(lit_by("evening@90").rgb != lit_by("evening").rgb);
    CHECK(lit_by("gradient@90").rgb == lit_by("gradient").rgb);
}

TEST_CASE("sky: one that cannot be is a wrong call that says what can")
{
    const test::TemporaryFolder folder;
    for (const char* word : {"red", "-1", "1,2", "1,2,3,4", "1,,2", "1,2,", "nan", "inf", "1e12", "0.5x", "studio,1",
                             "studio@", "studio@x", "studio@400", "night@3"}) {
        INFO(word);
        check_refused(reference(folder / "p.png", {"--sky", word}), 2,
                      Catch::Contains("--sky") &&
                          Catch::Contains("takes studio, gradient, overcast, evening or black") &&
                          Catch::Contains("a colour such as 0.8 or 1,0.9,0.7, or a picture"));
    }
    CHECK(folder.entries() == 0);
}

TEST_CASE("sky: --sky takes a picture, which lights as its pixels say")
{
    const test::TemporaryFolder folder;
    // Two scanlines of eight grey pixels of radiance 1/2, flat RGBE.
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n";
    for (int pixel = 0; pixel < 8; ++pixel) hdr += "\x80\x80\x80\x80";
    test::write_content(folder / "room.hdr", hdr);
    const double picture = mean_of(lit_by(folder / "room.hdr"), 1), colour = mean_of(lit_by("0.5"), 1);
    CHECK(picture == Approx(colour).epsilon(0.02));
    check_refused(reference(folder / "p.png", {"--sky", folder / "no.exr"}), 1, "no.exr");
}

TEST_CASE("exposure: --exposure multiplies all light, counts more than the scene file, and bake and reference agree")
{
    const test::TemporaryFolder folder;
    const auto picture = [&](const test::Arguments& more) {
        done(reference(folder / "p.png", more));
        return read_png(folder / "p.png").rgb;
    };
    CHECK(picture({"--sky", "0.8", "--exposure", "-1"}) == picture({"--sky", "0.4"}));
    const auto baked = [&](const test::Arguments& more) {
        done(lumi(joined(
            {"bake", LUMI_TEST_SCENE, "-o", folder / "f.lumi", "--origins", "40", "--directions", "40", "--spp", "4"},
            more)));
        return test::content_of(folder / "f.lumi");
    };
    CHECK(baked({"--sky", "0.8", "--exposure", "-1"}) == baked({"--sky", "0.4"}));
    for (const char* stops : {"nan", "inf", "-21", "20.5", "", "x"})
        CHECK(reference(folder / "p.png", {"--exposure", stops}).code == 2);
}

TEST_CASE("exposure: bake and reference choose and say the same one, and --exposure is another")
{
    const test::TemporaryFolder folder;
    test::write_content(
        folder / "s.json",
        std::string(R"({"objects": [{"obj": ")") + LUMI_TEST_SCENE +
            R"("}], "lights": [{"type": "directional", "direction": [-1, -1, -1], "irradiance": 900}]})");
    const auto said = [&](const test::Arguments& call) {
        const test::Outcome outcome = done(lumi(call));
        const size_t begin = outcome.err.find("lumi: the exposure is set to -");
        return begin == std::string::npos ? "" : outcome.err.substr(begin, outcome.err.find('\n', begin) - begin);
    };
    const std::string line = said({"reference", folder / "s.json", "-o", folder / "p.png", "--size", "8x8"});
    CHECK_THAT(line, Catch::Contains("stops"));
    CHECK(said({"bake", folder / "s.json", "-o", folder / "f.lumi", "--origins", "40", "--directions", "40", "--spp",
                "1"}) == line);
    CHECK(said({"reference", folder / "s.json", "-o", folder / "p.png", "--size", "8x8", "--exposure", "-9"}).empty());
}

TEST_CASE("colours: --colours display darkens what MTL says, also of a model in a scene file")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "m.mtl", "newmtl a\nKd 0.5 0.5 0.5\n");
    test::write_content(folder / "m.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    test::write_content(folder / "s.json", R"({"objects": [{"obj": "m.obj"}]})");
    const auto brightness = [&](const char* scene, const char* colours) {
        done(lumi({"reference", folder / scene, "-o", folder / "p.png", "--size", "16x16", "--spp", "64", "--sky", "1",
                   "--colours", colours}));
        return mean_of(read_png(folder / "p.png"), 1);
    };
    for (const char* scene : {"m.obj", "s.json"})
        CHECK(brightness(scene, "display") < 0.8 * brightness(scene, "linear"));
}

TEST_CASE("reference: an .exr holds linear light, before exposure, and its coverage in place of a background")
{
    const test::TemporaryFolder folder;
    const auto bytes = [&](const test::Arguments& more) {
        done(reference(folder / "p.exr", more));
        return test::content_of(folder / "p.exr");
    };
    const std::string light = bytes({"--sky", "40"});
    CHECK(light.substr(0, 4) == "\x76\x2f\x31\x01");
    CHECK(bytes({"--sky", "40", "--exposure", "-3"}) == light);
    CHECK(bytes({"--sky", "20"}) != light);
    // A sky of that picture is read: the reader of skies takes what the writer wrote.
    CHECK(reference(folder / "q.png", {"--sky", folder / "p.exr"}).code == 0);
    for (const test::Arguments& more : {test::Arguments{"--background", "ff00ff"},
                                        test::Arguments{"--over", folder / "q.png", "--pose", folder / "pose.txt"}}) {
        check_refused(lumi(joined({"reference", LUMI_TEST_SCENE, "-o", folder / "q.exr"}, more)), 2,
                      Catch::Contains(more[0]) && Catch::Contains("leave it out"));
    }
}

TEST_CASE("footprint: --footprint says what a texel is the mean of")
{
    const test::TemporaryFolder folder;
    const auto baked = [&](const std::string& footprint) {
        done(lumi({"bake", LUMI_TEST_SCENE, "-o", folder / "f.lumi", "--origins", "40", "--directions", "40", "--spp",
                   "4", "--footprint", footprint}));
        return test::content_of(folder / "f.lumi");
    };
    const std::string point = baked("point"), origin = baked("origin"), both = baked("both");
    CHECK(point != origin);
    CHECK(point != both);
    CHECK(origin != both);
    check_refused(lumi({"bake", LUMI_TEST_SCENE, "-o", folder / "f.lumi", "--footprint", "cell"}), 2,
                  Catch::Contains("point") && Catch::Contains("origin") && Catch::Contains("both"));
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
    check_refused(bake({"--beam", "parallel", "--footprint", "point"}), 2,
                  Catch::Contains("--footprint point") && Catch::Contains("one ray"));
}

TEST_CASE("view: a camera of the file draws what its saved pose draws, and a name that no camera has is refused")
{
    const test::TemporaryFolder folder;
    test::write_content(
        folder / "m.gltf",
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AACAvwAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"cameras":[{"type":"perspective","perspective":{"yfov":0.6,"znear":0.1}}],
"nodes":[{"mesh":0,"name":"leaf"},{"camera":0,"name":"Front","translation":[0.2,0.3,4]}],"scenes":[{"nodes":[0,1]}]})");
    const auto reference = [&](const std::string& picture, const test::Arguments& more) {
        return lumi(
            joined({"reference", folder / "m.gltf", "-o", folder / picture, "--size", "40x24", "--spp", "4"}, more));
    };
    const test::Outcome seen = done(reference("a.png", {"--view", "Front", "--save-pose", folder / "p.txt"}));
    const size_t fov = seen.err.find("--fov ");
    REQUIRE(fov != std::string::npos);
    // 0.6 radians from top to bottom of 24 pixels are 54.5° over 40.
    CHECK(std::stod(seen.err.substr(fov + 6)) == Approx(54.5).margin(0.1));
    REQUIRE(reference("b.png", {"--pose", folder / "p.txt", "--fov", seen.err.substr(fov + 6, 5)}).code == 0);
    CHECK(read_png(folder / "a.png").rgb == read_png(folder / "b.png").rgb);
    CHECK_THAT(reference("c.png", {"--view", "front"}).err,
               Catch::Contains("m.gltf") && Catch::Contains("choose among: Front"));
    CHECK_THAT(lumi({"reference", LUMI_TEST_SCENE, "-o", folder / "c.png", "--view", "Front"}).err,
               Catch::Contains("no camera in it"));
    CHECK_THAT(reference("c.png", {"--frame", "twig"}).err, Catch::Contains("choose among: leaf"));
}

}  // namespace lumi::tools
