// SPDX-License-Identifier: MIT
// Surface fields through the program.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "draw/draw_surface.h"
#include "image/picture_file.h"
#include "lumi/host/png.h"
#include "metrics/metrics.h"
#include "support/program.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::tools
{

namespace
{

using test::joined;
using test::lumi;

std::string write_surface(const test::TemporaryFolder& folder)
{
    test::write_content(folder / "s.lumi", test::small_surface_bytes());
    return folder / "s.lumi";
}

}  // namespace

TEST_CASE("bake writes the bytes of a surface field, and says nothing of a mesh that misses nothing")
{
    const test::TemporaryFolder folder;
    const test::Outcome outcome = done(lumi(
        joined({"bake", test::write_cube(folder.path()), "-o", folder / "f.lumi"}, test::small_surface_options())));
    CHECK_THAT(outcome.out, !Catch::Contains("missing"));
    CHECK((test::content_of(folder / "f.lumi") == test::small_surface_bytes()));
}

TEST_CASE("render draws surface fields in every mode of theirs, by default the best")
{
    const test::TemporaryFolder folder;
    const std::string field = write_surface(folder);
    const auto drawn = [&](const test::Arguments& more) {
        done(lumi(joined({"render", field, "-o", folder / "o.png", "--size", "64x64"}, more)));
        return read_png(folder / "o.png");
    };
    const Picture best = drawn({});
    CHECK(drawn({"--mode", "2x2"}).rgb == best.rgb);
    const Picture smooth = drawn({"--mode", "antialiased"}), rough = drawn({"--mode", "one-sample"});
    CHECK(smooth.rgb != best.rgb);
    CHECK(psnr_db(smooth, best) > psnr_db(rough, best));
    CHECK(psnr_db(drawn({"--pixel", "rgb565"}), best) > 35);
    const Picture dithered = drawn({"--pixel", "rgb565-dithered"}), rolled = drawn({"--roll", "90"});
    CHECK(dithered.rgb != drawn({"--pixel", "rgb565"}).rgb);
    CHECK(psnr_db(dithered, best) > 34);
    Picture upright = best;  // what is up turns to the right
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) std::copy_n(rolled.pixel(63 - y, x), 3, upright.pixel(x, y));
    CHECK(psnr_db(upright, best) > 40);
    CHECK(drawn({"--background", "00ff00"}).pixel(0, 0)[1] == 255);
}

TEST_CASE("render draws over a dark grey gradient, over black where it is told so, or over nothing")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "c.lumi", test::field_bytes({}));
    const std::string surface = write_surface(folder), png = folder / "o.png";
    const auto drawn = [&](const test::Arguments& call, const std::string& background) {
        const test::Arguments over =
            background.empty() ? test::Arguments{} : test::Arguments{"--background", background};
        done(lumi(joined(joined({"render", "-o", png, "--size", "64x64"}, call), over)));
        return host::decode_png(test::content_of(png), true);
    };
    SurfaceField field;
    const auto& file = test::small_surface().file;
    REQUIRE(open_surface(file.data(), file.size(), field) == FieldError::none);
    const Eye eye = {host::make_pose({30, 20, 3}), host::make_image(64, 64, host::framing_fov_deg(64, 64, 3)), {}};
    CHECK((drawn({surface}, "black").rgb == draw_surface(field, eye).rgb));
    for (const test::Arguments& call : {test::Arguments{surface, "--mode", "2x2"},
                                        {surface, "--mode", "antialiased"},
                                        {surface, "--mode", "one-sample"},
                                        {folder / "c.lumi"}}) {
        const auto gradient = drawn(call, ""), black = drawn(call, "black"), alone = drawn(call, "none");
        CHECK(black.alpha.empty());
        CHECK(gradient.alpha.empty());
        CHECK((gradient.rgb[0] >= 33 && gradient.rgb[0] <= 60));
        CHECK((black.rgb == drawn(call, "#000000").rgb));
        REQUIRE(alone.alpha.size() == 64 * 64);
        for (size_t i = 0; i < black.rgb.size(); ++i)
            if (alone.alpha[i / 3] == 255) CHECK(gradient.rgb[i] == black.rgb[i]);
        for (const char* colour : {"ffe0c0", "30a080"}) {
            const auto over = drawn(call, colour);
            const uint8_t* const back = over.rgb.data();  // the first pixel lies beside the object
            int worst = 0;
            for (size_t i = 0; i < over.rgb.size(); ++i) {
                const int alpha = alone.alpha[i / 3];
                const int laid = (alone.rgb[i] * alpha + back[i % 3] * (255 - alpha) + 127) / 255;
                worst = std::max(worst, std::abs(laid - over.rgb[i]));
            }
            CHECK(worst <= 1);
        }
    }
}

TEST_CASE("render refuses modes of the other kind of field, and names those of its own")
{
    const test::TemporaryFolder folder;
    const std::string surface = write_surface(folder), chord = folder / "c.lumi";
    test::write_content(chord, test::field_bytes({}));
    const std::vector<std::pair<test::Arguments, std::string>> calls = {
        {{surface, "--mode", "paper"}, "choose one-sample, antialiased or 2x2"},
        {{surface, "--span", "8"}, "--span belongs to chord fields"},
        {{chord, "--mode", "2x2"}, "choose nearest, linear or paper"},
    };
    for (const auto& [call, hint] : calls)
        check_refused(lumi(joined({"render", "-o", folder / "o.png"}, call)), 2, hint);
}

TEST_CASE("inspect accounts for every byte of a surface field")
{
    const test::TemporaryFolder folder;
    const std::string field = write_surface(folder);
    const auto json = nlohmann::json::parse(lumi({"inspect", field, "--json", "--verify"}).out);
    CHECK(json["layout"] == "surface");
    CHECK(json["triangles"] == test::small_surface().triangles);
    CHECK(json["vertices"] == test::small_surface().vertices);
    CHECK(json["texels"].get<uint32_t>() >= test::small_surface().texels);
    CHECK(json["texel_format"] == "palette8");
    CHECK(json["radius"].get<double>() > 1);
    uint64_t sum = json["other_bytes"];
    for (const auto& section : json["sections"]) {
        sum += section["bytes"].get<uint64_t>();
        CHECK(section["intact"] == true);
    }
    CHECK(sum == json["bytes"].get<uint64_t>());
    const std::string text = lumi({"inspect", field}).out;
    for (const char* word : {"surface", "triangles", "view table", "SVTX", "STEX"})
        CHECK_THAT(text, Catch::Contains(word));
}

TEST_CASE("inspect --screen --rows --for tells RAM, stack and rates of that screen and part, for people and as JSON")
{
    const test::TemporaryFolder folder;
    const std::string field = write_surface(folder);
    const auto told = [&](const test::Arguments& more) {
        return nlohmann::json::parse(lumi(joined({"inspect", field, "--json"}, more)).out);
    };
    const auto large = told({"--screen", "466x300", "--rows", "8", "--for", "esp32s3"}), usual = told({"--rows", "16"});
    CHECK(large["screen"]["width_px"] == 466);
    CHECK(large["screen"]["height_px"] == 300);
    CHECK(large["screen"]["rows"] == 8);
    CHECK(large["ram_bytes"]["2x2"]["stripe"] == 466 * 8 * 2);
    CHECK(large["ram_bytes"]["2x2"]["view"] > large["ram_bytes"]["one-sample"]["view"]);
    CHECK(large["stack_bytes"] == 3072);
    CHECK(large["chips"].size() == 1);
    CHECK(large["chips"]["esp32s3"]["estimated"] == true);
    CHECK(usual["chips"].size() == 8);
    CHECK(usual["chips"]["rp2040"]["estimated"] == false);
    CHECK(large["frames_per_second"]["2x2"]["esp32s3"] < usual["frames_per_second"]["2x2"]["esp32s3"]);
    CHECK(told({"--rows", "4"})["frames_per_second"]["2x2"]["rp2040"] < usual["frames_per_second"]["2x2"]["rp2040"]);
    CHECK_FALSE(told({}).contains("ram_bytes"));

    const std::string text = lumi({"inspect", field, "--screen", "466x466", "--for", "esp32s3@20fps,rp2040"}).out;
    for (const char* word : {"466 x 466 pixels of 16 bits in stripes of 16 rows", "mean (worst) of 200 poses",
                             "ESP32-S3* ", "14912 bytes; RP2040 ", "less than 3072 bytes of stack on Cortex-M",
                             "* estimated", "ESP32-S3: ", "estimated), "})
        CHECK_THAT(text, Catch::Contains(word));
    CHECK_THAT(text, !Catch::Contains("STM32"));
}

TEST_CASE("a screen that no part has RAM for is told so, and a screen that none can be is refused")
{
    const test::TemporaryFolder folder;
    const std::string field = write_surface(folder);
    const std::string text = lumi({"inspect", field, "--screen", "2000x2000", "--rows", "100"}).out;
    CHECK_THAT(text, Catch::Contains("STM32F407 too little RAM"));
    CHECK_THAT(text, Catch::Contains("mean (worst) of 11 poses"));  // each of which is drawn
    for (const test::Arguments& wrong : {test::Arguments{"--screen", "466"},
                                         {"--screen", "0x466"},
                                         {"--rows", "0"},
                                         {"--screen", "9000x10"},
                                         {"--for", "z80"}})
        check_refused(lumi(joined({"inspect", field}, wrong)), 2, wrong[0] + " takes");
}

}  // namespace lumi::tools
