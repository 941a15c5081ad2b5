// SPDX-License-Identifier: MIT
// Light states, through the program.
#include <catch2/catch.hpp>
#include <cmath>

#include "image/picture_file.h"
#include "metrics/metrics.h"
#include "support/program.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::tools
{
namespace
{

using test::check_told;
using test::joined;
using test::lumi;

// A floor, and a panel that shines on it. Azimuth 0 looks at the panel.
std::string write_room(const test::TemporaryFolder& folder, const std::string& gloss = "")
{
    test::write_content(folder / "room.mtl",
                        "newmtl grey\nKd 0.6 0.5 0.4\n" + gloss + "newmtl panel\nKd 0 0 0\nKe 0.9 0.5 0.2\n");
    const std::string obj = folder / "room.obj";
    test::write_content(obj,
                        "mtllib room.mtl\no floor\nusemtl grey\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"
                        "o lamp\nusemtl panel\nv -0.9 -0.8 0.1\nv -0.9 0.8 0.1\nv -0.9 0.8 0.9\nv -0.9 -0.8 0.9\n"
                        "f 5 6 7 8\n");
    return obj;
}

Picture lit_picture(const test::Arguments& arguments, const std::string& output, const std::string& eye = "0,35,3")
{
    done(lumi(joined(arguments, {"-o", output, "--size", "64x64", "--orbit", eye, "--background", "black"})));
    return read_png(output);
}

}  // namespace

TEST_CASE("states: a field shows the light that the reference of the scene has, and by default all of it")
{
    const test::TemporaryFolder folder;
    const std::string scene = write_room(folder), field = folder / "room.lumi";
    const test::Arguments same = {"--up", "z", "--sky", "0.8", "--exposure", "0"};
    done(lumi(joined({"bake", scene, "-o", field, "--fit", "60kB", "--paths", "30", "--state", "panel"}, same)));
    const Picture all = lit_picture({"render", field}, folder / "a.png");
    const std::vector<test::Arguments> lights = {{"--state", "panel=1"},
                                                 {"--state", "panel=0"},
                                                 {"--state", "base=0.05", "--state", "panel=0.3"},
                                                 {"--state", "base=0", "--state", "panel=0.1,0.6,1"}};
    for (const test::Arguments& weights : lights) {
        const Picture shown = lit_picture(joined({"render", field}, weights), folder / "f.png");
        const test::Arguments traced = joined({"reference", scene, "--spp", "64"}, same);
        const Picture truth = lit_picture(joined(traced, weights), folder / "r.png");
        INFO(weights.back());
        CHECK(psnr_db(shown, truth) > 28);
        CHECK((psnr_db(shown, all) > 45) == (weights.back() == "panel=1"));
    }
    check_told({"render", field, "-o", folder / "n.png", "--state", "pannel=1"},
               "named 'pannel' (did you mean panel?); choose among: base, panel");
    check_told({"render", field, "-o", folder / "n.png", "--tint", "panel=1"}, "write --state panel=WEIGHT");
    for (const std::string word : {"panel", "panel=2", "panel=1,2", "=1", "panel=-1", "panel="})
        check_told({"render", field, "-o", folder / "n.png", "--state", word}, "takes NAME=WEIGHT");
}

TEST_CASE("states: a lamp alone looks as in a field of that lamp, and what it does not reach stays black")
{
    const test::TemporaryFolder folder;
    const std::string scene = write_room(folder, "Pm 1\nPr 0.4\n"), field = folder / "room.lumi",
                      own = folder / "own.lumi", below = "180,-85,3";
    const test::Arguments same = {"--up", "z", "--exposure", "0"}, size = {"--fit", "60kB", "--paths", "30"},
                          bake = joined({"bake", scene}, joined(same, size)), sky = {"--sky", "studio"},
                          alone = {"--state", "base=0"};
    done(lumi(joined(bake, joined(sky, {"-o", field, "--state", "panel"}))));
    done(lumi(joined(bake, {"--sky", "black", "-o", own})));
    const test::Arguments dark = joined({"render", field}, alone);
    const Picture shown = lit_picture(dark, folder / "f.png"), best = lit_picture({"render", own}, folder / "o.png"),
                  truth = lit_picture(joined({"reference", scene, "--spp", "64", "--sky", "black"}, same),
                                      folder / "r.png");
    CHECK(psnr_db(shown, truth) > psnr_db(best, truth) - 1);
    const Picture black = lit_picture(dark, folder / "b.png", below),
                  lit = lit_picture({"render", field}, folder / "l.png", below);
    CHECK(std::isinf(psnr_db(black, Picture(64, 64))));
    CHECK(psnr_db(lit, black) < 20);
    const test::Outcome told = lumi(joined(joined({"report", scene, field, "--json", "--count", "1", "--spp", "16",
                                                   "--size", "32", "--cache", folder / "kept"},
                                                  same),
                                           joined(sky, alone)));
    const std::string key = "\"psnr_db\": ";
    CHECK(std::stod(told.out.substr(told.out.find(key) + key.size())) > 25);
}

TEST_CASE("states: a tint shows the model's colour until another is chosen, and then that, with its bounced light")
{
    const test::TemporaryFolder folder;
    const std::string scene = write_room(folder), field = folder / "room.lumi";
    const test::Arguments same = {"--up", "z", "--sky", "0.5", "--exposure", "0"};
    done(lumi(joined({"bake", scene, "-o", field, "--fit", "60kB", "--paths", "30", "--tint", "grey"}, same)));
    const test::Arguments traced = joined({"reference", scene, "--spp", "64"}, same);
    const Picture own = lit_picture({"render", field}, folder / "a.png");
    CHECK(psnr_db(own, lit_picture(traced, folder / "r.png")) > 28);
    for (const std::string colour : {"0.6,0.5,0.4", "0.7,0.1,0.05", "0", "0.2,0.3,0.8"}) {
        const test::Arguments painted = {"--tint", "grey=" + colour};
        const Picture shown = lit_picture(joined({"render", field}, painted), folder / "f.png");
        INFO(colour);
        CHECK(psnr_db(shown, lit_picture(joined(traced, painted), folder / "r.png")) > 28);
        CHECK((psnr_db(shown, own) > 40) == (colour == "0.6,0.5,0.4"));
    }
    check_told({"bake", scene, "-o", folder / "n.lumi", "--tint", "gray"}, "did you mean grey?");
    check_told({"bake", scene, "-o", folder / "n.lumi", "--tint", "grey", "--state", "panel"}, "light states or tints");
    check_told({"reference", scene, "-o", folder / "n.png", "--tint", "grey=2"}, "takes NAME=COLOUR");
    check_told({"render", field, "-o", folder / "n.png", "--state", "grey=0.5"}, "write --tint grey=COLOUR");
    check_told({"render", field, "-o", folder / "n.png", "--tint", "gray=0.5"}, "choose among: grey");
    REQUIRE(lumi({"inspect", field}).code == 0);
    CHECK_THAT(lumi({"inspect", field}).out, Catch::Contains("tint          grey"));
}

TEST_CASE("states: what has none, or cannot, says so")
{
    const test::TemporaryFolder folder;
    const std::string scene = write_room(folder);
    const test::Arguments bake = {"bake", scene, "-o", folder / "n.lumi", "--state"};
    check_told(joined(bake, {"lamp"}), "choose among: sky, panel");
    check_told(joined(bake, {"panel", "--layout", "chord"}), "a chord field has no light states");
    check_told(joined(bake, {"panel", "--shard", "1/2"}), "is baked whole");
    check_told(joined(bake, {"base"}), "name another light by --state, too; base is the rest");
    test::write_content(folder / "s.lumi", test::small_surface_bytes());
    check_told({"render", folder / "s.lumi", "-o", folder / "n.png", "--state", "a=1"}, "bake it with --state");
}

}  // namespace lumi::tools
