// SPDX-License-Identifier: MIT
// No command destroys a file that it reads, nor writes two outputs to one file, whatever names lead there.
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>

#include "image/picture_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::tools
{

namespace
{

namespace fs = std::filesystem;
using test::Outcome;
using test::write_content;

const char* const kObj =
    "mtllib s.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl m\n"
    "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
const char* const kSky = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x80\x80\x81";
const std::string kTinyBake = " --origins 8 --directions 8 --spp 1";
const std::string kTinySurfaceBake = " --layout surface --triangles 20 --longest-edge 2 --texel-density 4 --paths 4";
const std::string kTinyPicture = " --size 16x16 --spp 1 --sky studio";

// A folder with something of everything that commands read, and other names for some of it.
struct Workshop {
    test::TemporaryFolder folder;

    Workshop()
    {
        for (const char* name :
             {"s.obj", "p.part", "n.new", "b.part.new", "y.1-of-2.shard", "r-001.png", "r-sheet.png"})
            write_content(folder / name, kObj);
        write_content(folder / "s.mtl", "newmtl m\nmap_Kd t.png\n");
        write_content(folder / "sky.hdr", kSky);
        write_content(folder / "s.json", R"({"objects": [{"obj": "s.obj"}], "environment": {"picture": "sky.hdr"}})");
        for (const char* name : {"f.lumi", "e.S", "h.h", "v-000.png", "v-sheet.png"})
            write_content(folder / name, test::field_bytes({}));
        write_png(folder / "t.png", Picture(4, 4));
        write_png(folder / "a.png", Picture(20, 20));
        Picture white(20, 20);
        white.rgb.assign(white.rgb.size(), 255);
        write_png(folder / "b.png", white);
        write_png(folder / "mask.png", white);
        for (const auto& [link, target] : kLinks) fs::create_symlink(target, folder / link);
        for (const auto& [link, target] : kHardLinks) fs::create_hard_link(folder / target, folder / link);
    }

    // A shell in the folder.
    Outcome run(const std::string& call) const
    {
        return test::run_program(
            {"sh", "-c", "cd '" + folder.path() + "' && exec '" + std::string(LUMI_PROGRAM) + "' " + call});
    }

    // Every entry's bytes, or where a link leads to.
    std::map<std::string, std::string> entries() const
    {
        std::map<std::string, std::string> all;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder.path())) {
            const std::string name = entry.path().filename().string();
            all[name] = entry.is_symlink() ? "-> " + fs::read_symlink(entry.path()).string()
                                           : test::content_of(entry.path().string());
        }
        return all;
    }

private:
    using Links = std::vector<std::pair<std::string, std::string>>;
    const Links kLinks = {{"link.obj", "s.obj"},      {"link.mtl", "s.mtl"},   {"link.png", "t.png"},
                          {"link.lumi", "f.lumi"},    {"link-a.png", "a.png"}, {"two.h", "two.S"},
                          {"q-001.png", "q-000.png"}, {"z.part", "s.mtl"},     {"deep", "."},
                          {"obj.png", "s.obj"},       {"mtl.png", "s.mtl"},    {"sky.png", "sky.hdr"},
                          {"field.png", "f.lumi"},    {"obj.html", "s.obj"},   {"mtl.html", "s.mtl"},
                          {"texture.html", "t.png"},  {"field.html", "f.lumi"}};
    const Links kHardLinks = {{"hard.mtl", "s.mtl"},
                              {"hard.lumi", "f.lumi"},
                              {"hard-mtl.png", "s.mtl"},
                              {"hard-field.png", "f.lumi"},
                              {"hard.html", "f.lumi"}};
};

// Checks `lumi CALL` in a workshop: it fails, names `file` and the mend, and leaves every file as it was.
void check_refused(const std::string& call, const std::string& file, const std::string& mend)
{
    const Workshop shop;
    const auto before = shop.entries();
    check_refused(shop.run(call), 1, Catch::StartsWith("lumi: " + file + ": ") && Catch::EndsWith("; " + mend + "\n"));
    const auto after = shop.entries();
    CHECK(after.size() == before.size());
    for (const auto& [name, content] : before) {
        INFO(name);
        CHECK((after.count(name) == 1 && after.at(name) == content));
    }
}

void check_input_kept(const std::string& call, const std::string& file)
{
    check_refused(call, file, "choose another name for the output");
}

void check_twins_refused(const std::string& call, const std::string& file)
{
    check_refused(call, file, "give each output a name of its own");
}

}  // namespace

TEST_CASE("own files: bake keeps every file of its scene, under any name")
{
    for (const std::string& more : {kTinyBake, kTinySurfaceBake}) {
        check_input_kept("bake s.obj -o s.obj" + more, "s.obj");
        check_input_kept("bake s.obj -o s.mtl" + more, "s.mtl");
        check_input_kept("bake s.obj -o t.png" + more, "t.png");
    }
    for (const char* name : {"./s.obj", "deep/s.mtl", "link.obj", "link.mtl", "hard.mtl", "link.png"})
        check_input_kept("bake s.obj -o " + std::string(name) + kTinyBake, name);
    check_input_kept("bake link.obj -o s.obj" + kTinyBake, "s.obj");
    for (const char* name : {"s.json", "s.obj", "s.mtl", "sky.hdr", "t.png"})
        check_input_kept("bake s.json -o " + std::string(name) + kTinyBake, name);
}

TEST_CASE("own files: a field that is given as a scene is called a field")
{
    const Workshop workshop;
    check_refused(test::lumi({"bake", workshop.folder / "f.lumi"}), 1, "f.lumi: this is a field already; draw it by");
}

TEST_CASE("own files: bake's checkpoint and its unfinished files spare the scene")
{
    check_input_kept("bake p.part -o p --restart" + kTinyBake, "p.part");
    check_input_kept("bake n.new -o n" + kTinyBake, "n.new");
    check_input_kept("bake b.part.new -o b" + kTinyBake, "b.part.new");
    check_input_kept("bake s.obj -o z --restart" + kTinyBake, "z.part");
    check_input_kept("bake y.1-of-2.shard -o y --shard 1/2 --restart" + kTinyBake, "y.1-of-2.shard");
}

TEST_CASE("own files: a clash ends a bake before its work begins")
{
    const std::string endless = " --spp 16000000";
    check_input_kept("bake s.obj -o t.png" + endless, "t.png");
    check_input_kept("bake s.obj -o z" + endless, "z.part");
    check_input_kept("bake s.obj -o t.png --fit 100kB" + endless, "t.png");
    check_input_kept("bake s.obj -o x.lumi --fit 100kB --plan s.mtl" + endless, "s.mtl");
    check_twins_refused("bake s.obj -o x.lumi --fit 100kB --plan x.lumi" + endless, "x.lumi");
    check_input_kept("reference s.obj -o mtl.png --size 16x16 --sky studio" + endless, "mtl.png");
    check_input_kept("report s.obj f.lumi -o texture.html" + endless, "texture.html");
}

TEST_CASE("own files: merge keeps its shards, and names those that are missing")
{
    const Workshop shop;
    for (const char* shard : {"1/2", "2/2"})
        REQUIRE(shop.run("bake s.obj -o g --shard " + std::string(shard) + kTinyBake).code == 0);
    fs::copy_file(shop.folder / "g.2-of-2.shard", shop.folder / "m.new");
    fs::create_symlink("g.1-of-2.shard", shop.folder / "link.shard");
    fs::create_hard_link(shop.folder / "g.1-of-2.shard", shop.folder / "hard.shard");
    const auto before = shop.entries();
    const std::pair<std::string, std::string> calls[] = {
        {"merge g.1-of-2.shard g.2-of-2.shard -o g.2-of-2.shard", "g.2-of-2.shard"},
        {"merge g.1-of-2.shard g.2-of-2.shard -o link.shard", "link.shard"},
        {"merge g.1-of-2.shard g.2-of-2.shard -o hard.shard", "hard.shard"},
        {"merge g.1-of-2.shard m.new -o m", "m.new"}};
    for (const auto& [call, file] : calls) {
        check_refused(
            shop.run(call), 1,
            Catch::StartsWith("lumi: " + file + ": ") && Catch::EndsWith("; choose another name for the output\n"));
        CHECK((shop.entries() == before));
    }
    check_refused(shop.run("merge none.shard g.1-of-2.shard -o n"), 1,
                  Catch::StartsWith("lumi: none.shard: cannot be opened") &&
                      Catch::Contains("\nlumi: shard 2 of 2 is missing; bake it with --shard 2/2"));
    CHECK_THAT(done(shop.run("merge g.2-of-2.shard g.1-of-2.shard -o n")).out, Catch::Contains(" rays from 2 shards"));
}

TEST_CASE("own files: render keeps its field, also from views and the sheet of a turntable")
{
    for (const char* name : {"field.png", "hard-field.png"})
        check_input_kept("render f.lumi --size 16x16 -o " + std::string(name), name);
    check_input_kept("render v-000.png --size 16x16 --turntable 2 -o v.png", "v-000.png");
    check_input_kept("render v-sheet.png --size 16x16 --turntable 2 -o v.png", "v-sheet.png");
    check_twins_refused("render f.lumi --size 16x16 --turntable 2 -o q.png", "q-001.png");
}

TEST_CASE("own files: reference keeps every file of its scene, also from a turntable")
{
    for (const char* name : {"obj.png", "mtl.png", "t.png", "hard-mtl.png"})
        check_input_kept("reference s.obj" + kTinyPicture + " -o " + name, name);
    check_input_kept("reference s.json" + kTinyPicture + " -o sky.png", "sky.png");
    check_input_kept("reference r-001.png" + kTinyPicture + " --turntable 2 -o r.png", "r-001.png");
    check_input_kept("reference r-sheet.png" + kTinyPicture + " --turntable 2 -o r.png", "r-sheet.png");
}

TEST_CASE("own files: compare keeps both pictures and the mask")
{
    for (const char* name : {"a.png", "b.png", "mask.png", "link-a.png"})
        check_input_kept("compare a.png b.png --mask mask.png --error-picture " + std::string(name), name);
}

TEST_CASE("own files: report keeps scene and fields")
{
    const std::string call = "report s.obj f.lumi --spp 1 --count 1";
    for (const char* name : {"obj.html", "mtl.html", "texture.html", "field.html", "hard.html"})
        check_input_kept(call + " -o " + name, name);
}

TEST_CASE("own files: embed keeps its field and does not write source and header to one file")
{
    check_input_kept("embed e.S -o e.S", "e.S");
    check_input_kept("embed h.h -o h.S", "h.h");
    check_twins_refused("embed f.lumi -o two.S", "two.h");
}

TEST_CASE(
    "own files: no command replaces other work, though it does not read it, but what lumi wrote under such a name")
{
    const Workshop shop;
    REQUIRE(shop.run("bake s.obj -o surface.lumi" + kTinySurfaceBake).code == 0);
    REQUIRE(shop.run("bake s.json -o surface.lumi" + kTinySurfaceBake).code == 0);
    const std::string flashed = "embed f.lumi -o f.bin",
                      plan = "bake s.obj --layout surface --fit 100kB --plan-only --plan plan.json",
                      source = "embed f.lumi -o own.c", odd = "bake s.obj -o odd.field" + kTinyBake;
    for (const std::string& call : {flashed, flashed, plan, plan, source, source, odd, odd})
        CHECK(shop.run(call).code == 0);
    for (const char* name : {"x.OBJ", "x.gltf", "x.glb", "x.stl", "x.ply", "x.nii", "x.nii.gz", "x.vdb", "x.bin", "x.c",
                             "x.cpp", "x.S", "x.blend", "noending"})
        write_content(shop.folder / name, "other work");
    write_png(shop.folder / "photo.png", Picture(4, 4));
    fs::create_symlink("x.glb", shop.folder / "link.html");
    const auto before = shop.entries();
    const std::pair<std::string, std::string> calls[] = {{"bake s.obj -o x.OBJ" + kTinyBake, "x.OBJ"},
                                                         {"embed f.lumi -o x.bin", "x.bin"},
                                                         {"embed f.lumi -o x.c", "x.c"},
                                                         {"embed f.lumi -o x.cpp", "x.cpp"},
                                                         {"embed f.lumi -o x.S", "x.S"},
                                                         {"view f.lumi -o link.html", "link.html"},
                                                         {"view e.S -o field.html", "field.html"},
                                                         {plan.substr(0, plan.rfind(' ')) + " f.lumi", "f.lumi"},
                                                         {plan.substr(0, plan.rfind(' ')) + " s.json", "s.json"}};
    for (const auto& [call, file] : calls)
        check_refused(shop.run(call), 1, file + ": this holds other work, which the output would replace");
    for (const char* name : {"s.mtl", "x.gltf", "x.glb", "x.stl", "x.ply", "x.nii", "x.nii.gz", "x.vdb", "x.blend",
                             "noending", "photo.png"})
        CHECK(shop.run("bake s.obj -o " + std::string(name) + kTinyBake).code == 1);
    CHECK((shop.entries() == before));
}

TEST_CASE("own files: outputs may replace earlier outputs, be new, or be a device twice")
{
    const Workshop shop;
    const std::vector<std::string> calls = {
        "bake s.obj -o new.lumi" + kTinyBake,
        "bake s.obj -o new.lumi" + kTinyBake + " --seed 2",
        "bake s.obj -o new.lumi --shard 1/2" + kTinyBake,
        "bake s.obj -o new.lumi --shard 1/2" + kTinyBake,
        "bake s.obj -o surface.lumi" + kTinySurfaceBake,
        "render new.lumi -o a.png --size 16x16",
        "render new.lumi -o a.png --size 16x16",
        "reference s.obj -o a.png" + kTinyPicture,
        "embed new.lumi -o own.S",
        "embed new.lumi -o own.S",
        "report s.obj new.lumi --spp 1 --count 1 -o /dev/null --json",
        "report s.obj new.lumi --spp 1 --count 1 -o r.html --json",
        "report s.obj new.lumi --spp 1 --count 1 -o r.html --json",
    };
    for (const std::string& call : calls) done(shop.run(call));
    CHECK(test::content_of(shop.folder / "s.obj") == kObj);
}

}  // namespace lumi::tools
