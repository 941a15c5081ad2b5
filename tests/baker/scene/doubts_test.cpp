// SPDX-License-Identifier: MIT
// Scenes that can hardly be meant get one warning of each kind, with the mend; scenes that can be meant get none.
#include <catch2/catch.hpp>

#include "lumi/baker/scene.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using testing::ScratchFolder;

// A cube around a place, faces looking outwards, and texts to add.
std::string cube_at(double x, double half, int first = 1)
{
    std::string text;
    for (int k = 0; k < 8; ++k) {
        const auto c = [&](int bit) { return (k & bit) != 0 ? half : -half; };
        text += "v " + std::to_string(x + c(1)) + " " + std::to_string(c(2)) + " " + std::to_string(c(4)) + "\n";
    }
    for (const auto& f :
         {std::array<int, 4>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        text += "f";
        for (const int k : f) text += " " + std::to_string(first + k);
        text += "\n";
    }
    return text;
}

std::string doubts_of(const std::string& obj, const std::string& mtl = "", const std::string& json = "")
{
    const ScratchFolder folder;
    folder.write("m.mtl", mtl);
    const std::filesystem::path file = folder.write("s.obj", "mtllib m.mtl\n" + obj);
    std::vector<std::string> warnings;
    load_scene(json.empty() ? file : folder.write("s.json", R"({"objects": [{"obj": "s.obj"}], )" + json + "}"), {},
               warnings);
    std::string text;
    for (const std::string& w : warnings) text += w + "\n";
    return text;
}

void check_doubt(const std::string& text, const std::string& what)
{
    CHECK_THAT(text, Catch::Contains(what) && Catch::Contains("; "));
    CHECK(std::count(text.begin(), text.end(), '\n') == 1);
}

const std::string kLamp = R"("environment": 0, "lights": [{"type": "point", "intensity": 3, "position": )";

}  // namespace

TEST_CASE("doubts: a sound scene has none")
{
    CHECK(doubts_of(cube_at(0, 1)).empty());
    CHECK(doubts_of(cube_at(0, 1) + cube_at(5, 1, 9)).empty());
    CHECK(doubts_of(cube_at(0, 1), "", kLamp + "[0, 3, 0]}]").empty());
}

TEST_CASE("doubts: lamps that a closed body encloses")
{
    const std::string two = kLamp + "[0, 0, 0]}, {\"type\": \"point\", \"intensity\": 3, \"position\": [0, 3, 0]}]";
    check_doubt(doubts_of(cube_at(0, 1), "", two), "1 lamp(s) are inside closed bodies");
    check_doubt(doubts_of(cube_at(0, 1), "", kLamp + "[0, 0, 0]}]"), "no lamp lights what is seen");
    const std::string cube = cube_at(0, 1), open = cube.substr(0, cube.rfind("f "));
    CHECK(doubts_of(open, "", kLamp + "[0, 0, 0]}]").empty());
    CHECK(doubts_of("usemtl x\n" + cube, "newmtl x\nd 0.5\n", kLamp + "[0, 0, 0]}]").empty());
    CHECK(doubts_of("usemtl x\n" + cube, "newmtl x\nKe 1 1 1\n", R"("environment": 0)").empty());
}

TEST_CASE("doubts: nothing opaque")
{
    CHECK_THAT(doubts_of("usemtl x\n" + cube_at(0, 1), "newmtl x\nd 0\n"), Catch::Contains("all of it is transparent"));
}

TEST_CASE("doubts: a ground, or a stray triangle, that makes the rest tiny is named with its material and the share")
{
    const std::string ground =
        "usemtl lawn\nv 500 -1 500\nv 500 -1 -500\nv -500 -1 -500\nv -500 -1 500\nf 9 10 11 12\n";
    const std::string mtl = "newmtl lawn\nKd 0 1 0\n";
    const std::string huge = doubts_of(cube_at(0, 1) + ground, mtl);
    check_doubt(huge, "one part of 2 triangle(s) of the material 'lawn'");
    CHECK_THAT(huge, Catch::Contains("fills 0.3 %"));
    check_doubt(doubts_of(cube_at(0, 1) + "v 300 0 0\nv 300 0.1 0\nv 300 0 0.1\nf 9 10 11\n"),
                "one part of 1 triangle(s)");
    CHECK(doubts_of(cube_at(0, 1) + "v 9 0 0\nv 9 1 0\nv 9 0 1\nf 9 10 11\n").empty());
}

TEST_CASE("doubts: faces of two materials in one place, those of one material are harmless")
{
    const std::string mtl = "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n", cube = cube_at(0, 1);
    const std::string faces = cube.substr(cube.find("f "));
    check_doubt(doubts_of("usemtl a\n" + cube + "usemtl b\n" + faces, mtl), "12 face(s) coincide");
    CHECK(doubts_of("usemtl a\n" + cube + faces, mtl).empty());
}

TEST_CASE("doubts: open glass")
{
    const std::string mtl = "newmtl g\nNi 1.5\nillum 7\n", cube = cube_at(0, 1);
    check_doubt(doubts_of("usemtl g\n" + cube.substr(0, cube.rfind("f ")), mtl), "glass is open at 4 edge(s)");
    CHECK(doubts_of("usemtl g\n" + cube, mtl).empty());
}

TEST_CASE("doubts: two far objects of a scene file cannot keep their shape in 32 bits")
{
    CHECK(doubts_of(cube_at(4e6, 0.5)).empty());  // moved before it is rounded
    CHECK_THAT(doubts_of(cube_at(4e6, 0.5), "", R"("tone": "srgb")"), Catch::Contains("so far from its origin"));
}

}  // namespace lumi::baker
