// SPDX-License-Identifier: MIT
// These tests hold the command line to its promises about exit codes, messages and earlier output.
#include <catch2/catch.hpp>
#include <filesystem>

#include "image/picture_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"
#include "support/test_pictures.h"

namespace lumi::tools
{

using test::Arguments;
using test::kScene;
using test::lumi;
using test::Outcome;

TEST_CASE("a wrong call ends with 2, says what is wrong on stderr and writes nothing")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", test::field_bytes({}));
    const std::string field = folder / "f.lumi", png = folder / "o.png", baked = folder / "o.lumi";
    const auto render = [&](const std::string& option, const std::string& value) {
        return Arguments{"render", field, "-o", png, option, value};
    };
    const auto bake = [&](const std::string& option, const std::string& value) {
        return Arguments{"bake", kScene, "-o", baked, option, value};
    };
    const std::vector<std::pair<Arguments, std::string>> calls = {
        {{}, "lumi --help"},
        {{"frob"}, "there is no subcommand \"frob\""},
        {{"rendr", field}, "there is no subcommand \"rendr\" (did you mean render?)"},
        {{"help", "bak"}, "there is no subcommand \"bak\" (did you mean bake?)"},
        {{"bkae", field}, "there is no subcommand \"bkae\" (did you mean bake?)"},
        {render("--orbits", "30,20,3"), "there is no option --orbits (did you mean --orbit?)"},
        {{"render"}, "lumi render --help"},
        {{"render", field}, "--output"},
        {bake("--layout", "guided"), "auto, surface or chord"},
        {{"bake", kScene, "-o", baked, "--triangles", "50", "--origins", "64"}, "leave one of them out"},
        {{"bake", kScene, "-o", baked, "--layout", "surface", "--spp", "4"}, "--spp does not go with --layout surface"},
        {{"bake", kScene, "-o", baked, "--layout", "chord", "--paths", "4"}, "--paths does not go with --layout chord"},
        {{"bake", kScene, "-o", baked, "--layout", "chord", "--gloss-maps", "1"},
         "--gloss-maps does not go with --layout chord"},
        {{"compare", png}, "lumi compare --help"},
        {render("--frob", "1"), "--frob"},
        {{"render", field, "-o", folder / "o.tga"}, "o.png, not \""},
        {{"reference", kScene, "-o", folder / "o.tga"}, "o.png, not \""},
        {{"compare", png, png, "--error-picture", folder / "o"}, "o.png, not \""},
        {{"render", field, "-o", png, "--over", png, "--pixel", "rgb565"}, "--pixel rgb888 only"},
        {{"render", field, "-o", png, "--pose", "p.txt", "--orbit", "1,2,3"}, "--orbit"},
        {render("--size", "240"), "WIDTHxHEIGHT"},
        {render("--size", "9000x10"), "8192"},
        {render("--orbit", "1,2"), "AZIMUTH,ELEVATION,DISTANCE"},
        {render("--orbit", "0,0,0.9"), "radii above 1"},
        {render("--orbit", "0,91,3"), "-90"},
        {render("--fov", "150"), "--fov"},
        {render("--mode", "cubic"), "nearest, linear or paper"},
        {render("--neighbours", "0"), "--neighbours"},
        {render("--neighbours", "10"), "--neighbours"},
        {render("--neighbours", "3"), "--mode paper"},
        {render("--span", "3"), "--span"},
        {{"render", field, "-o", png, "--mode", "paper", "--span", "8"}, "paper draws every pixel exactly"},
        {render("--mode", "dither"), "nearest, linear or paper"},
        {render("--background", "red"), "RRGGBB"},
        {{"render", field, "-o", png, "--background", "none", "--pixel", "rgb565"}, "--pixel rgb888 only"},
        {{"view", field, "-o", folder / "p.html", "--background", "none"}, "gradient, black or a colour"},
        {{"view", field, "-o", png}, "--output takes a page (.html), not "},
        {{"report", kScene, field, "-o", field}, "--output takes a page (.html), not "},
        {render("--pixel", "rgb332"), "rgb888, rgb565, rgb565-dithered or grey8"},
        {render("--turntable", "0"), "--turntable"},
        {bake("--texel", "rgb"), "palette8"},
        {bake("--shard", "3"), "K/COUNT"},
        {bake("--shard", "0/3"), "from 1 to COUNT"},
        {bake("--shard", "4/3"), "from 1 to COUNT"},
        {bake("--progress", "xml"), "auto or json"},
        {{"merge", "-o", baked}, "lumi merge --help"},
        {bake("--cap", "2000"), "50%"},
        {bake("--cap", "1"), "from 2 to"},
        {bake("--origins", "0"), "--origins"},
        {bake("--directions", "2000000"), "--directions"},
        {bake("--spp", "0"), "--spp"},
        {bake("--up", "x"), "y or z"},
        {bake("--threads", "-1"), "--threads takes a whole number from 0 to 1024, not \"-1\""},
        {bake("--threads", "1.5"), "--threads takes a whole number from 0 to 1024, not \"1.5\""},
        {bake("--threads", "many"), "--threads takes a whole number from 0 to 1024, not \"many\""},
        {bake("--threads", "99999999999"), "--threads takes a whole number from 0 to 1024, not \"99999999999\""},
        {bake("--seed", "x"), "--seed takes a whole number from 0 to 18446744073709551615, not \"x\""},
        {bake("--cap", "1e-300%"), "50%"},
        {{"bake", kScene, "-o", baked, "--layout", "surface", "--cap", "150%"}, "50%"},
        {render("--span", "32"), "--span takes 0, 1, 2, 4, 8 or 16, not \"32\""},
        {{"bake", kScene, "--spp", "1", "--spp", "1", "--spp", "2"}, "--spp is given 3 times; give it once"},
        {{"bake", kScene, "--restart=foo"}, "--restart takes no value, not \"foo\""},
        {{"bake", kScene, "--fit"}, "--fit needs a value behind it: SIZE"},
        {bake("--for", ","), "--for takes no empty word between commas, not \",\""},
        {{"inspect", field, "--for", "rp2040,,rp2350"}, "no empty word"},
        {{"inspect", field, "--for", "rp2040,z80"}, "not \"z80\""},
        {{"report", kScene, field, "--mode", ","}, "--mode takes no empty word"},
        {{"bake"}, "SCENE is missing"},
        {{"inspect", field, "other"}, "there is no place for the argument \"other\""},
        {{"render", field, "-o", png, "--pose", "p", "--orbit", "1,2,3"}, "leave one of them out"},
        {{"filter", "frob"}, "there is no subcommand \"frob\""},
        {{"render", field, "-o", png + "/"}, "--output takes a file, not the folder \""},
        {{"render", field, "-o", folder / ".png"}, "name it " + folder / "view.png"},
        {{"view", field, "--orbit", "30,20,1"}, "radii from 1.25 to 8; not \"30,20,1\""},
        {{"--"}, "lumi --help"},
        {{"bake", "--"}, "SCENE is missing"},
        {{"bake", kScene, "--", "--layout", "chord"}, "the argument \"./--layout\""},
        {{"inspect", field, "--", "--help"}, "\"./--help\""},
        {{"embed", field, "-o", folder / "field.txt"}, "ends in .S"},
        {{"embed", field, "-o", folder / "field.S", "--symbol", "a-b"}, "--symbol"},
        {{"embed", field, "-o", folder / "int.S"}, "\"int\" has a meaning of its own in C or C++; "},
        {{"embed", field, "-o", folder / "field.S", "--symbol", "concept"}, "with --symbol concept_field"},
    };
    for (const auto& [call, hint] : calls) {
        const Outcome outcome = lumi(call);
        INFO(outcome.err);
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.err, Catch::StartsWith("lumi: ") && Catch::Contains(hint));
        CHECK(outcome.out.empty());
        CHECK(folder.entries() == 1);
    }
}

TEST_CASE("behind -- each word is a file, whatever it begins with")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "-f.lumi", test::field_bytes({}));
    const std::string begin = "cd '" + folder.path() + "' && '" + LUMI_PROGRAM + "' ";
    for (const char* call :
         {"inspect -- -f.lumi", "inspect --json -- -f.lumi", "-- inspect ./-f.lumi", "inspect ./-f.lumi --"})
        CHECK(test::run_program({"sh", "-c", begin + call}).code == 0);
}

TEST_CASE("help says what --help says")
{
    CHECK(lumi({"help"}).out == lumi({"--help"}).out);
    CHECK(lumi({"help", "render"}).out == lumi({"render", "--help"}).out);
    CHECK(lumi({"help", "render"}).code == 0);
}

TEST_CASE("compare ends with 1 for a picture below the wanted PSNR, and still tells all figures")
{
    const test::TemporaryFolder folder;
    write_png(folder / "black.png", Picture(20, 20));
    write_png(folder / "dark.png", Picture(20, 20, {16, 16, 16}));  // 24.05 dB
    const Arguments call = {"compare", folder / "dark.png", folder / "black.png", "--json", "--min-psnr"};
    const auto with = [&](const std::string& least) {
        Arguments arguments = call;
        arguments.push_back(least);
        return lumi(arguments);
    };
    CHECK(with("24").code == 0);
    CHECK(with("24.1").code == 1);
    CHECK(with("24.1").out == with("24").out);
    CHECK_THAT(with("24.1").err, Catch::Contains("dark.png: has 24.05 dB, less than --min-psnr 24.1; "));
}

TEST_CASE("every subcommand has a help text with an example")
{
    CHECK(lumi({"--help"}).code == 0);
    CHECK_THAT(lumi({"--help"}).out, Catch::Contains("130 interrupted"));
    CHECK(lumi({"--version"}).code == 0);
    CHECK_THAT(lumi({"--version"}).out, Catch::StartsWith("lumi 0.") && Catch::Contains("\nWith Embree "));
    for (const char* command : {"bake", "render", "reference", "compare", "inspect", "embed", "help"}) {
        const Outcome outcome = lumi({command, "--help"});
        CHECK(outcome.code == 0);
        CHECK_THAT(outcome.out, Catch::Contains(std::string("Example:\n  lumi ") + command));
    }
}

TEST_CASE("a failure ends with 1, names file, problem and mend, and leaves earlier output untouched")
{
    const test::TemporaryFolder folder;
    std::string damaged = test::field_bytes({});
    damaged.back() = static_cast<char>(damaged.back() ^ 1);
    test::write_content(folder / "damaged.lumi", damaged);
    test::write_content(folder / "short.lumi", damaged.substr(0, damaged.size() / 2));
    write_png(folder / "small.png", Picture(20, 20));
    write_png(folder / "large.png", Picture(30, 20));
    write_png(folder / "tiny.png", Picture(5, 5));
    test::write_content(folder / "bad.obj", "f 1 2 3\n");
    const std::string out = folder / "out.png", asm_out = folder / "out.S", baked = folder / "out.lumi";
    const std::vector<std::pair<Arguments, std::string>> calls = {
        {{"render", folder / "damaged.lumi", "-o", out},
         "damaged.lumi: the texel section's bytes are damaged (CRC); copy the file again or bake it again"},
        {{"render", folder / "short.lumi", "-o", out}, "short.lumi: "},
        {{"render", folder / "none.lumi", "-o", out}, "none.lumi: cannot be read (No such file or directory); "},
        {{"bake", folder / "none.obj", "-o", baked}, "none.obj"},
        {{"bake", folder / "bad.obj", "-o", baked}, "bad.obj"},
        {{"reference", folder / "none.obj", "-o", out}, "none.obj"},
        {{"compare", folder / "small.png", folder / "large.png", "--error-picture", out}, "large.png: is 30x20 but "},
        {{"compare", folder / "tiny.png", folder / "tiny.png"}, "tiny.png: is 5x5"},
        {{"compare", folder / "small.png", folder / "short.lumi"}, "it is no PNG picture"},
        {{"inspect", folder / "short.lumi"}, "short.lumi: "},
        {{"inspect", folder / "damaged.lumi", "--verify"}, "damaged.lumi: the texel section"},
        {{"embed", folder / "damaged.lumi", "-o", asm_out}, "damaged.lumi: the texel section"},
        {{"report", kScene, folder / "damaged.lumi"}, "damaged.lumi: the texel section"},
    };
    const std::string earlier = "/* Written by `lumi embed`. */";
    for (const std::string& file : {out, asm_out, baked}) test::write_content(file, earlier);
    const size_t entries = folder.entries();
    for (const auto& [call, hint] : calls) {
        Outcome outcome = lumi(call);
        // The last line: on a machine with much to do, lines that tell what takes long come first.
        if (outcome.err.size() > 1) outcome.err.erase(0, outcome.err.rfind('\n', outcome.err.size() - 2) + 1);
        check_refused(outcome, 1, Catch::StartsWith("lumi: ") && Catch::Contains(hint) && Catch::Contains("; "));
        for (const std::string& file : {out, asm_out, baked}) CHECK(test::content_of(file) == earlier);
        CHECK(folder.entries() == entries);
    }
}

TEST_CASE("an old guided field is refused by every command, with what to do")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "g.lumi",
                        test::text_of({{detail::format::four_cc('G', 'U', 'I', 'D'), 1, lumi::test::Bytes(44, 1)}}));
    const std::string field = folder / "g.lumi";
    const std::vector<Arguments> calls = {{"render", field, "-o", folder / "o.png"},
                                          {"inspect", field},
                                          {"embed", field, "-o", folder / "o.S"},
                                          {"report", kScene, field}};
    for (const auto& call : calls)
        check_refused(lumi(call), 1, "g.lumi: guided fields ended with version 0.1.0; bake it again");
    CHECK(folder.entries() == 1);
}

TEST_CASE("lumi starts without OpenVDB's libraries, and names them where their module is missing")
{
    CHECK_THAT(test::run_program({"ldd", LUMI_PROGRAM}).out,
               !Catch::Contains("openvdb") && !Catch::Contains("log4cplus"));
    const test::TemporaryFolder folder;
    std::filesystem::copy_file(LUMI_PROGRAM, folder / "lumi");  // alone
    test::write_content(folder / "smoke.vdb", "any");
    check_refused(test::run_program({folder / "lumi", "bake", folder / "smoke.vdb", "--iso", "1"}), 1,
                  Catch::Contains("lumi was built without OpenVDB; ") && Catch::Contains("libopenvdb-dev"));
}

TEST_CASE("an output in a folder that does not exist is refused before the work begins")
{
    const test::TemporaryFolder folder;
    check_refused(lumi({"bake", kScene, "-o", folder / "none/o.lumi", "--spp", "1000000"}), 1,
                  "create its folder first");
}

TEST_CASE("Ctrl-C ends a bake or a reference with 130 and leaves earlier output untouched")
{
    const test::TemporaryFolder folder;
    for (const char* command : {"bake", "reference"}) {
        const bool bakes = std::string(command) == "bake";
        const std::string output = folder / (bakes ? "o.lumi" : "o.png");
        test::write_content(output, "earlier");
        const Outcome outcome = test::lumi_interrupted({command, kScene, "-o", output, "--spp", "1000000"});
        INFO(command << ": " << outcome.err);
        CHECK(outcome.code == 130);
        CHECK_THAT(outcome.err, Catch::Contains("interrupted"));
        CHECK(test::content_of(output) == "earlier");
        CHECK_THAT(outcome.err,
                   Catch::Contains(bakes ? "o.lumi.part keeps what is done" : "earlier output is untouched"));
        std::filesystem::remove(output + ".part");
        std::filesystem::remove(output);
        CHECK(folder.entries() == 0);
    }
}

}  // namespace lumi::tools
