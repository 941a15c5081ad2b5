// SPDX-License-Identifier: MIT
// Good and hostile OBJ files: a correct picture or a message that names file, line and mend, never a crash.
#include <catch2/catch.hpp>

#include "scene/scene_data.h"
#include "support/obj_files.h"

namespace lumi::baker
{
namespace
{

using testing::kCorners;
using testing::kRedPixel;
using testing::load_obj;
using testing::load_obj_file;
using testing::LoadedObj;
using testing::ScratchFolder;

void check_refused(const std::string& text, const std::string& line, const std::string& what)
{
    INFO(text);
    CHECK_THROWS_WITH(load_obj(text),
                      Catch::Contains("scene.obj" + line + ": ") && Catch::Contains(what) && Catch::Contains("; "));
}

double area(const Mesh& mesh)
{
    double sum = 0;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) sum += static_cast<double>(mesh.area(t));
    return sum;
}

}  // namespace

TEST_CASE("obj: triangles, quads and polygons keep their area, without normals they are flat")
{
    const LoadedObj l = load_obj(std::string(kCorners) + "v 0.5 0.5 0\nf 1 2 3 4\nf 1 2 5\nf 1 2 3 5 4\n");
    CHECK(l.warnings.empty());
    CHECK(l.parts.mesh.triangle_count() == 2 + 1 + 3);
    CHECK(area(l.parts.mesh) == Approx(1 + 0.25 + 0.75));
    CHECK(l.parts.mesh.shading[0][0] == kNoIndex);
    CHECK(l.parts.materials.size() == 1);
}

TEST_CASE("obj: negative indices, texture coordinates and normals")
{
    const LoadedObj l = load_obj(std::string(kCorners) +
                                 "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 2\nf -4/1/1 -3/2/1 -2/3/-1\nf 1//1 3//1 4//1\n");
    CHECK(l.warnings.empty());
    REQUIRE(l.parts.mesh.triangle_count() == 2);
    CHECK(l.parts.mesh.mapping[0][2] == 2);
    CHECK(l.parts.mesh.mapping[1][0] == kNoIndex);
    CHECK(l.parts.mesh.shading[1][0] == 0);
    CHECK(static_cast<double>(l.parts.mesh.normals[0].z) == 1);
}

TEST_CASE("obj: smoothing groups make normals where none are given")
{
    const LoadedObj l = load_obj(std::string(kCorners) + "v 0 0 1\ns 1\nf 1 2 3\nf 1 5 2\ns off\nf 1 3 4\n");
    REQUIRE(l.parts.mesh.triangle_count() == 3);
    REQUIRE(l.parts.mesh.shading[0][0] != kNoIndex);
    const Vec3 shared = l.parts.mesh.normals[static_cast<size_t>(l.parts.mesh.shading[0][0])];
    CHECK(static_cast<double>(shared.z) == Approx(std::sqrt(0.5)).epsilon(1e-5));
    CHECK(l.parts.mesh.shading[2][0] == kNoIndex);
}

TEST_CASE("obj: numbers that are none, infinite or too large")
{
    check_refused("v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", ":2", "'nan' is not a finite number");
    check_refused("v 0 0 inf\n", ":1", "'inf' is not a finite number");
    check_refused("v 0 0 1e400\n", ":1", "not a finite number");
    check_refused("v 0 0 1e30\n", ":1", "too large");
    check_refused("v 0,5 0 0\n", ":1", "'0,5' is not a finite number");
    check_refused("\n# c\nv 0 0\n", ":3", "needs 3 numbers and has 2");
    check_refused(std::string(kCorners) + "vn 0 0 nan\n", ":5", "not a finite number");
    check_refused(std::string(kCorners) + "vt nan 0\n", ":5", "not a finite number");
}

TEST_CASE("obj: numbers that tinyobjloader alone would misread")
{
    const auto corner_of = [](const std::string& x) {
        const LoadedObj l = load_obj("v " + x + " 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n");
        return l.parts.mesh.positions.at(0).x;
    };
    CHECK(corner_of("0e999") == 0);
    CHECK(corner_of("-25e-2") == -0.25f);
    CHECK(corner_of("0." + std::string(400, '0') + "5e400") == 0.5f);
    CHECK(corner_of("0." + std::string(30, '3')) == 1 / 3.0f);
    CHECK(corner_of("1\v") == 1);
    check_refused("v 1e2147483648 0 0\n", ":1", "not a finite number");
    check_refused("v +-1 0 0\n", ":1", "'+-1' is not a finite number");
    check_refused(std::string(kCorners) + "f 1 2 4294967297\n", ":5", "uses vertex 4294967297");
    check_refused(std::string(kCorners) + "f 1/0 2/0 3/0\n", ":5", "uses texture coordinate 0");
}

TEST_CASE("obj: names keep their blanks, and lines end as they like")
{
    const LoadedObj l = load_obj("v 0 0 0\rv 1 0 0\r\nv 0 1 0\ng  a  b\rusemtl x  y\rf 1 2 3\ro c\rf 1 2 3");
    REQUIRE(l.parts.named.size() == 2);
    CHECK(l.parts.named[0].name == "a  b");
    CHECK(l.parts.named[0].end == 1);
    CHECK(l.parts.named[1].name == "c");
    CHECK(l.parts.materials.at(0).name == "x  y");
    CHECK_THAT(l.warnings, Catch::Contains("scene.obj:5: "));
}

TEST_CASE("obj: lines of very many words and very many names of libraries are read once")
{
    std::string text = kCorners, face = "f";
    for (int k = 0; k < 100000; ++k) face += " 1 2 3";
    for (int k = 0; k < 2000; ++k) text += "mtllib m.mtl\n";
    const LoadedObj l = load_obj(text + "l" + face.substr(1) + "\nf 1 2 3\n");
    CHECK(l.parts.mesh.triangle_count() == 1);
    CHECK(std::count(l.warnings.begin(), l.warnings.end(), '\n') == 2);
}

TEST_CASE("obj: files that hold nothing to draw")
{
    check_refused("", "", "there is no face");
    check_refused("# only a comment\n", "", "there is no face");
    check_refused(kCorners, "", "there is no face");
    check_refused("v 1 1 1\nf 1 1 1\n", "", "no face has an area");
    check_refused(std::string("v 0 0 0\n\0\0", 10), "", "this is no text");
    CHECK_THROWS_WITH(load_obj_file("no such.obj"), Catch::Contains("no such.obj: the file cannot be opened"));
}

TEST_CASE("obj: corners may end in slashes without a number behind them")
{
    for (const std::string face : {"f 1/ 2/ 3/", "f 1// 2// 3//", "f 1//1 2// 3/"}) {
        INFO(face);
        CHECK(load_obj(kCorners + std::string("vn 0 0 1\n") + face + "\n").parts.mesh.triangle_count() == 1);
    }
    check_refused(kCorners + std::string("f /1 2 3\n"), ":5", "is no vertex number");
}

TEST_CASE("obj: faces that point nowhere")
{
    check_refused(std::string(kCorners) + "f 1 2 5\n", ":5", "uses vertex 5, but there are 4");
    check_refused(std::string(kCorners) + "f 1 2 -5\n", ":5", "uses vertex -5");
    check_refused(std::string(kCorners) + "f 0 1 2\n", ":5", "uses vertex 0");
    check_refused(std::string(kCorners) + "f 1/1 2/1 3/1\n", ":5", "uses texture coordinate 1, but there are 0");
    check_refused(std::string(kCorners) + "f 1//9 2//9 3//9\n", ":5", "uses normal 9");
    check_refused(std::string(kCorners) + "f a b c\n", ":5", "'a' is no vertex number");
    check_refused(std::string(kCorners) + "f 1/1/1/1 2 3\n", ":5", "");
}

TEST_CASE("obj: a face of many corners is drawn whole")
{
    std::string text, face = "f";
    constexpr int kCount = 1000;
    for (int k = 0; k < kCount; ++k) {
        const double angle = 2 * 3.14159265358979 * k / kCount;
        text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
        face += " " + std::to_string(k + 1);
    }
    const LoadedObj l = load_obj(text + face + "\n");
    CHECK(l.warnings.empty());
    CHECK(area(l.parts.mesh) == Approx(3.14159).epsilon(1e-4));
}

TEST_CASE("obj: what is no face costs its line, and one warning for each kind with its count")
{
    const LoadedObj l = load_obj(std::string(kCorners) +
                                 "f 1 2\nf\nf 3\nl 1 2 3\np 4\ncurv 0 1 1 2\nbanana 1\nbanana 2\n"
                                 "f 1 2 3 4\n");
    CHECK(l.parts.mesh.triangle_count() == 2);
    CHECK_THAT(l.warnings, Catch::Contains("scene.obj:5: 3 face(s) have fewer than three corners"));
    CHECK_THAT(l.warnings, Catch::Contains("scene.obj:8: 2 line(s) and point(s)"));
    CHECK_THAT(l.warnings, Catch::Contains("scene.obj:10: 1 free-form"));
    CHECK_THAT(l.warnings, Catch::Contains("scene.obj:11: 2 line(s) begin with 'banana'"));
    CHECK(std::count(l.warnings.begin(), l.warnings.end(), '\n') == 4);
    check_refused(std::string(kCorners) + "l 1 2\n", "", "only lines and points");
    check_refused(std::string(kCorners) + "curv 0 1 1 2\n", "", "only free-form");
}

TEST_CASE("obj: faces may come before what they use, and words may be written in capitals")
{
    const LoadedObj early =
        load_obj(std::string("f 1/1/1 2/2/1 3/3/1\n") + kCorners + "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n");
    CHECK(early.warnings.empty());
    REQUIRE(early.parts.mesh.triangle_count() == 1);
    CHECK(early.parts.mesh.mapping[0][2] == 2);
    const LoadedObj capitals = load_obj("V 0 0 0\nV 1 0 0\nV 0 1 0\nF 1 2 3\n");
    CHECK(capitals.parts.mesh.triangle_count() == 1);
    CHECK_THAT(capitals.warnings, Catch::Contains("scene.obj:1: 4 line(s) begin with capital"));
    CHECK(load_obj(std::string(kCorners) + "fo 1 2 3\n").parts.mesh.triangle_count() == 1);
}

TEST_CASE("obj: a backslash joins lines, but not at the end of a comment or of a material's name")
{
    CHECK(load_obj("# C:\\models\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3\n").parts.mesh.triangle_count() == 1);
    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl a\\\nKd 0.25 0 0\n");
    const LoadedObj l =
        load_obj_file(folder.write("s.obj", std::string("mtllib m.mtl\n") + kCorners + "usemtl a\\\nf 1 2 3\n"));
    CHECK(l.warnings.empty());
    CHECK(l.parts.materials[0].base.r == 0.25f);
}

TEST_CASE("obj: vertices far from the origin keep their shape to the last digit of the file")
{
    const LoadedObj l =
        load_obj("v 4500000.001 600000 0\nv 4500000.003 600000 0\nv 4500000.001 600000.002 0\nf 1 2 3\n");
    CHECK(area(l.parts.mesh) == Approx(2e-6).epsilon(1e-3));
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    const std::filesystem::path file =
        folder.write("s.obj", "v 4500000.1 6 0\nv 4500000.3 6 0\nv 4500000.1 6.2 0\nf 1 2 3\n");
    const Scene scene = load_scene(file, {}, warnings);
    CHECK(static_cast<double>(scene.centre()[0]) == Approx(4500000.2));
    CHECK(static_cast<double>(scene.radius()) == Approx(0.1 * std::sqrt(2) * 1.01).epsilon(1e-4));
    folder.write("s.json", R"({"objects": [{"obj": "s.obj", "translate": [-4500000, 0, 0]}]})");
    CHECK(static_cast<double>(load_scene(folder.at("s.json"), {}, warnings).radius()) ==
          Approx(0.1 * std::sqrt(2) * 1.01).epsilon(1e-2));
}

TEST_CASE("obj: colours at vertices are drawn where a material has no picture, they run to 1 or to 255")
{
    const std::string red = "v 0 0 0 255 0 0\nv 1 0 0 255 0 0\nv 0 1 0 255 0 0\nf 1 2 3\n";
    const LoadedObj l = load_obj(red);
    CHECK(l.warnings.empty());
    REQUIRE(l.parts.textures.size() == 1);
    CHECK(l.parts.textures[0].rgb[0] == 255);
    CHECK(l.parts.textures[0].rgb[1] == 0);
    CHECK(l.parts.materials[0].base.r == 1);
    const LoadedObj weighted = load_obj("v 0 0 0 1 0 0.5 0\nv 1 0 0 1 0 0.5 0\nv 0 1 0 1 0 0.5 0\nf 1 2 3\n");
    REQUIRE(weighted.parts.textures.size() == 1);
    CHECK(weighted.parts.textures[0].rgb[1] == 128);
    CHECK(load_obj("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").parts.textures.empty());
    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\nmap_Kd t.png\n");
    folder.write("t.png", kRedPixel);
    const LoadedObj both =
        load_obj_file(folder.write("s.obj", "mtllib m.mtl\nvt 0 0\nusemtl x\n" + red + "f 1/1 2/1 3/1\n"));
    CHECK_THAT(both.warnings, Catch::Contains("1 material(s) have pictures, and colours") &&
                                  Catch::Contains("1 triangle(s) have no texture coordinates"));
    CHECK(both.parts.mesh.mapping[1][0] == 0);
}

TEST_CASE("obj: colours a little beyond 1 are no bytes")
{
    const auto colour_of = [](const std::string& colour) {
        const std::string v = " " + colour + "\n";
        const LoadedObj l = load_obj("v 0 0 0" + v + "v 1 0 0" + v + "v 0 1 0" + v + "f 1 2 3\n");
        REQUIRE(l.parts.textures.size() == 1);
        const auto& rgb = l.parts.textures[0].rgb;
        return std::vector<int>{rgb[0], rgb[1], rgb[2]};
    };
    CHECK(colour_of("1.2 0.8 0") == std::vector<int>{255, 204, 0});
    CHECK(colour_of("127.5 51 0") == std::vector<int>{128, 51, 0});
    CHECK(colour_of("2 1 0") == std::vector<int>{2, 1, 0});
}

TEST_CASE("obj: triangles without area are left out, and the first is named")
{
    const LoadedObj l = load_obj(std::string(kCorners) + "v 2 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 5\nf 1 2 2 3\n");
    CHECK(l.parts.mesh.triangle_count() == 2);
    CHECK_THAT(l.warnings, Catch::Contains("scene.obj:7: 3 face(s)"));
}

TEST_CASE("obj: tiny and huge scenes keep their triangles")
{
    for (const char* s : {"1e-12", "1e12"}) {
        const std::string one(s);
        const LoadedObj l = load_obj("v 0 0 0\nv " + one + " 0 0\nv 0 " + one + " 0\nf 1 2 3\n");
        CHECK(l.warnings.empty());
        std::vector<std::string> warnings;
        const ScratchFolder folder;
        const Scene scene =
            load_scene(folder.write("s.obj", "v 0 0 0\nv " + one + " 0 0\nv 0 " + one + " 0\nf 1 2 3\n"), {}, warnings);
        CHECK(static_cast<double>(scene.radius()) == Approx(std::stod(one) * std::sqrt(0.5) * 1.01).epsilon(1e-5));
    }
}

TEST_CASE("obj: every truncation of a good file loads or is refused with a message")
{
    const std::string text = std::string("mtllib m.mtl\nusemtl x\n") + kCorners +
                             "vn 0 0 1\nvt 0 0\ns 1\nf 1/1/1 2/1/1 3/1/1 4/1/1\ng a\nf 1 2 3\n";
    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\nKd 0.5 0.5 0.5\n");
    for (size_t size = 0; size <= text.size(); ++size) {
        const std::filesystem::path file = folder.write("s.obj", text.substr(0, size));
        try {
            const LoadedObj loaded = load_obj_file(file);
            CHECK(loaded.parts.mesh.triangle_count() > 0);
        } catch (const SceneError& e) {
            CHECK_THAT(e.what(), Catch::Contains("s.obj"));
        }
    }
}

TEST_CASE("scene: the sphere holds what faces use, in scene axes, and nothing touches it")
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    const std::filesystem::path file = folder.write("s.obj", "v 10 0 0\nv 12 0 0\nv 11 1 0\nv 999 0 0\nf 1 2 3\n");
    const Scene scene = load_scene(file, {}, warnings);
    CHECK(static_cast<double>(scene.centre()[0]) == Approx(11));
    CHECK(static_cast<double>(scene.centre()[1]) == Approx(0).margin(1e-6));
    CHECK(static_cast<double>(scene.radius()) == Approx(1.01));
    CHECK(scene.triangle_count() == 1);
    CHECK(scene.light_count() == 0);
    for (const Mesh::Corners& c : scene.data().mesh.corners)
        for (const uint32_t k : c) CHECK(length(scene.data().mesh.positions[k]) < 0.995f);
    // y up: sphere(x,y,z) = scene(z,x,y).
    CHECK(static_cast<double>(scene.data().mesh.positions[2].z) == Approx(1 / 1.01));
    CHECK(static_cast<double>(scene.data().mesh.positions[1].y) == Approx(1 / 1.01));
}

}  // namespace lumi::baker
