// SPDX-License-Identifier: MIT
// Good and hostile OBJ and MTL files: a correct picture or a message that names file, line and mend, never a crash.
#include "model/obj_reader.h"

#include <png.h>
#include <catch2/catch.hpp>

#include "material/fresnel.h"
#include "scene/scene_data.h"
#include "support/picture_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using testing::ScratchFolder;

constexpr char kCorners[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

struct Loaded {
    SceneParts parts;
    std::string warnings;
};

Loaded load(const std::filesystem::path& file)
{
    Loaded loaded;
    std::vector<std::string> lines;
    loaded.parts = read_obj(file, lines);
    for (const std::string& line : lines) loaded.warnings += line + "\n";
    return loaded;
}

Loaded load_obj(const std::string& text)
{
    const ScratchFolder folder;
    return load(folder.write("scene.obj", text));
}

void check_refused(const std::string& text, const std::string& line, const std::string& what)
{
    INFO(text);
    CHECK_THROWS_WITH(load_obj(text),
                      Catch::Contains("scene.obj" + line + ": ") && Catch::Contains(what) && Catch::Contains("; "));
}

Material only_material(const std::string& mtl, std::string* warnings = nullptr)
{
    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\n" + mtl);
    const Loaded l = load(folder.write("s.obj", std::string("mtllib m.mtl\nusemtl x\n") + kCorners + "f 1 2 3\n"));
    if (warnings) *warnings = l.warnings;
    REQUIRE(l.parts.materials.size() == 1);
    return l.parts.materials[0];
}

double area(const Mesh& mesh)
{
    double sum = 0;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) sum += static_cast<double>(mesh.area(t));
    return sum;
}

const std::string kRedPixel = testing::rgb_png(1, {255, 0, 0});

}  // namespace

TEST_CASE("obj: triangles, quads and polygons keep their area, without normals they are flat")
{
    const Loaded l = load_obj(std::string(kCorners) + "v 0.5 0.5 0\nf 1 2 3 4\nf 1 2 5\nf 1 2 3 5 4\n");
    CHECK(l.warnings.empty());
    CHECK(l.parts.mesh.triangle_count() == 2 + 1 + 3);
    CHECK(area(l.parts.mesh) == Approx(1 + 0.25 + 0.75));
    CHECK(l.parts.mesh.shading[0][0] == kNoIndex);
    CHECK(l.parts.materials.size() == 1);
}

TEST_CASE("obj: negative indices, texture coordinates and normals")
{
    const Loaded l = load_obj(std::string(kCorners) +
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
    const Loaded l = load_obj(std::string(kCorners) + "v 0 0 1\ns 1\nf 1 2 3\nf 1 5 2\ns off\nf 1 3 4\n");
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

TEST_CASE("obj: files that hold nothing to draw")
{
    check_refused("", "", "there is no face");
    check_refused("# only a comment\n", "", "there is no face");
    check_refused(kCorners, "", "there is no face");
    check_refused("v 1 1 1\nf 1 1 1\n", "", "no face has an area");
    check_refused(std::string("v 0 0 0\n\0\0", 10), "", "this is no text");
    CHECK_THROWS_WITH(load("no such.obj"), Catch::Contains("no such.obj: the file cannot be opened"));
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
    const Loaded l = load_obj(text + face + "\n");
    CHECK(l.warnings.empty());
    CHECK(area(l.parts.mesh) == Approx(3.14159).epsilon(1e-4));
}

TEST_CASE("obj: what is no face costs its line, and one warning for each kind with its count")
{
    const Loaded l = load_obj(std::string(kCorners) +
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
    const Loaded early =
        load_obj(std::string("f 1/1/1 2/2/1 3/3/1\n") + kCorners + "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n");
    CHECK(early.warnings.empty());
    REQUIRE(early.parts.mesh.triangle_count() == 1);
    CHECK(early.parts.mesh.mapping[0][2] == 2);
    const Loaded capitals = load_obj("V 0 0 0\nV 1 0 0\nV 0 1 0\nF 1 2 3\n");
    CHECK(capitals.parts.mesh.triangle_count() == 1);
    CHECK_THAT(capitals.warnings, Catch::Contains("scene.obj:1: 4 line(s) begin with capital"));
    CHECK(load_obj(std::string(kCorners) + "fo 1 2 3\n").parts.mesh.triangle_count() == 1);
}

TEST_CASE("obj: a backslash joins lines, but not at the end of a comment or of a material's name")
{
    CHECK(load_obj("# C:\\models\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3\n").parts.mesh.triangle_count() == 1);
    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl a\\\nKd 0.25 0 0\n");
    const Loaded l = load(folder.write("s.obj", std::string("mtllib m.mtl\n") + kCorners + "usemtl a\\\nf 1 2 3\n"));
    CHECK(l.warnings.empty());
    CHECK(l.parts.materials[0].base.r == 0.25f);
}

TEST_CASE("obj: vertices far from the origin keep their shape to the last digit of the file")
{
    const Loaded l = load_obj("v 4500000.001 600000 0\nv 4500000.003 600000 0\nv 4500000.001 600000.002 0\nf 1 2 3\n");
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
    const Loaded l = load_obj(red);
    CHECK(l.warnings.empty());
    REQUIRE(l.parts.textures.size() == 1);
    CHECK(l.parts.textures[0].rgb[0] == 255);
    CHECK(l.parts.textures[0].rgb[1] == 0);
    CHECK(l.parts.materials[0].base.r == 1);
    const Loaded weighted = load_obj("v 0 0 0 1 0 0.5 0\nv 1 0 0 1 0 0.5 0\nv 0 1 0 1 0 0.5 0\nf 1 2 3\n");
    REQUIRE(weighted.parts.textures.size() == 1);
    CHECK(weighted.parts.textures[0].rgb[1] == 128);
    CHECK(load_obj("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").parts.textures.empty());
    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\nmap_Kd t.png\n");
    folder.write("t.png", kRedPixel);
    const Loaded both = load(folder.write("s.obj", "mtllib m.mtl\nvt 0 0\nusemtl x\n" + red + "f 1/1 2/1 3/1\n"));
    CHECK_THAT(both.warnings, Catch::Contains("1 material(s) have pictures, and colours") &&
                                  Catch::Contains("1 triangle(s) have no texture coordinates"));
    CHECK(both.parts.mesh.mapping[1][0] == 0);
}

TEST_CASE("obj: files are found in another letter case, in quotes, or by the OBJ's own name, and a warning says so")
{
    const ScratchFolder folder;
    folder.write("M.MTL", "newmtl x\nmap_Kd \"Two Words.PNG\"\n");
    folder.write("two words.png", kRedPixel);
    const std::string face = std::string(kCorners) + "usemtl x\nf 1 2 3\n";
    const Loaded l = load(folder.write("s.obj", "mtllib m.mtl\n" + face));
    CHECK(l.parts.textures.size() == 1);
    CHECK_THAT(l.warnings, Catch::Contains("s.obj:1: 1 material file(s) are found by another letter case") &&
                               Catch::Contains("is found as 'two words.png'"));
    folder.write("own.mtl", "newmtl x\nKd 0.25 0 0\n");
    const Loaded own = load(folder.write("own.obj", "mtllib lost.mtl\n" + face));
    CHECK(own.parts.materials[0].base.r == 0.25f);
    CHECK_THAT(own.warnings, Catch::Contains("lost.mtl' is missing") && Catch::Contains("by the OBJ's own name"));
}

TEST_CASE("obj: triangles without area are left out, and the first is named")
{
    const Loaded l = load_obj(std::string(kCorners) + "v 2 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 5\nf 1 2 2 3\n");
    CHECK(l.parts.mesh.triangle_count() == 2);
    CHECK_THAT(l.warnings, Catch::Contains("scene.obj:7: 3 face(s)"));
}

TEST_CASE("obj: tiny and huge scenes keep their triangles")
{
    for (const char* s : {"1e-12", "1e12"}) {
        const std::string one(s);
        const Loaded l = load_obj("v 0 0 0\nv " + one + " 0 0\nv 0 " + one + " 0\nf 1 2 3\n");
        CHECK(l.warnings.empty());
        std::vector<std::string> warnings;
        const ScratchFolder folder;
        const Scene scene =
            load_scene(folder.write("s.obj", "v 0 0 0\nv " + one + " 0 0\nv 0 " + one + " 0\nf 1 2 3\n"), {}, warnings);
        CHECK(static_cast<double>(scene.radius()) == Approx(std::stod(one) * std::sqrt(0.5) * 1.01).epsilon(1e-5));
    }
}

TEST_CASE("obj: a missing material file and an undefined material are named, and drawn grey")
{
    const Loaded l = load_obj(std::string("mtllib lost one.mtl\n") + kCorners + "usemtl brick wall\nf 1 2 3\n");
    CHECK_THAT(l.warnings, Catch::Contains("scene.obj:1: the material file 'lost one.mtl' is missing"));
    CHECK_THAT(l.warnings, Catch::Contains("scene.obj:6: the material 'brick wall' is not defined"));
    REQUIRE(l.parts.materials.size() == 1);
    CHECK(static_cast<double>(l.parts.materials[0].base.r) == Approx(0.6));
}

TEST_CASE("obj: names with blanks, backslashes and Windows line ends")
{
    const ScratchFolder folder;
    folder.write("sub dir/my mat.mtl", "newmtl red paint\r\nKd 1 1 1\r\nmap_Kd tex dir\\a red.png\r\n");
    folder.write("sub dir/tex dir/a red.png", kRedPixel);
    const Loaded l = load(folder.write("my scene.obj", std::string("mtllib sub dir\\my mat.mtl\r\n") + kCorners +
                                                           "vt 0 0\r\nusemtl red paint\r\nf 1/1 2/1 3/1\r\n"));
    CHECK(l.warnings.empty());
    REQUIRE(l.parts.textures.size() == 1);
    CHECK(l.parts.materials[0].maps.base.texture == 0);
    CHECK(l.parts.textures[0].rgb == std::vector<uint8_t>{255, 0, 0});
}

TEST_CASE("obj: a picture named by another machine's path is found beside the MTL file")
{
    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\nmap_Kd C:\\Users\\me\\red.png\n");
    folder.write("red.png", kRedPixel);
    const Loaded l =
        load(folder.write("s.obj", std::string("mtllib m.mtl\nusemtl x\nvt 0 0\n") + kCorners + "f 1/1 2/1 3/1\n"));
    CHECK(l.warnings.empty());
    CHECK(l.parts.textures.size() == 1);
    CHECK(static_cast<double>(l.parts.materials[0].base.r) == 1);  // no Kd: the picture as it is
}

TEST_CASE("obj: several material files, in one line or in several")
{
    const ScratchFolder folder;
    folder.write("a.mtl", "newmtl a\nKd 0.1 0.1 0.1\n");
    folder.write("b.mtl", "newmtl b\nKd 0.2 0.2 0.2\n");
    folder.write("c.mtl", "newmtl c\nKd 0.3 0.3 0.3\n");
    const Loaded l = load(folder.write("s.obj", std::string("mtllib a.mtl b.mtl\nmtllib c.mtl\n") + kCorners +
                                                    "usemtl c\nf 1 2 3\nusemtl a\nf 1 3 4\nusemtl b\nf 1 2 4\n"));
    CHECK(l.warnings.empty());
    REQUIRE(l.parts.materials.size() == 3);
    for (size_t t = 0; t < 3; ++t) {
        const double expected[] = {0.3, 0.1, 0.2};
        CHECK(static_cast<double>(l.parts.materials[l.parts.mesh.materials[t]].base.g) == Approx(expected[t]));
    }
}

TEST_CASE("mtl: missing and broken pictures are named, and the plain colour is used")
{
    std::string warnings;
    CHECK(only_material("Kd 0.2 0.3 0.4\nmap_Kd no.png\n", &warnings).maps.base.texture == kNoTexture);
    CHECK_THAT(warnings, Catch::Contains("m.mtl:3: the picture 'no.png' is missing"));

    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\nmap_Kd bad.png\n");
    folder.write("bad.png", "\x89PNG\r\n\x1a\nrubbish");
    const Loaded l = load(folder.write("s.obj", std::string("mtllib m.mtl\nusemtl x\n") + kCorners + "f 1 2 3\n"));
    CHECK_THAT(l.warnings, Catch::Contains("m.mtl:2: the picture") && Catch::Contains("is not used"));
}

TEST_CASE("mtl: numbers that are none are refused with their line, those out of range are clamped with a warning")
{
    CHECK_THROWS_WITH(only_material("Kd nan 0 0\n"), Catch::Contains("m.mtl:2: 'nan' is not a finite number"));
    CHECK_THROWS_WITH(only_material("Kd 0.5 0.5\n"), Catch::Contains("m.mtl:2: 'Kd' needs 3 numbers"));
    CHECK_THROWS_WITH(only_material("Ns\n"), Catch::Contains("m.mtl:2: 'Ns' needs 1 numbers"));
    CHECK_THROWS_WITH(only_material("d inf\n"), Catch::Contains("m.mtl:2"));
    std::string warnings;
    const Material m = only_material("Kd 2 -1 0.5\n", &warnings);
    CHECK(static_cast<double>(m.base.r) == 1);
    CHECK(static_cast<double>(m.base.g) == 0);
    CHECK_THAT(warnings, Catch::Contains("m.mtl:2: Kd 2 is out of range") && Catch::Contains("Kd -1"));
    CHECK(static_cast<double>(only_material("Kd 0.25\n").base.b) == Approx(0.25));
    const Material brushed = only_material("Pr 0.5\nPm 1\naniso 3\nPs -1\n", &warnings);
    CHECK(brushed.anisotropy == 1);
    CHECK(brushed.sheen == 0);
    CHECK_THAT(warnings, Catch::Contains("m.mtl:4: aniso 3 is out of range") && Catch::Contains("m.mtl:5: Ps -1"));
    CHECK_THROWS_WITH(only_material("anisor x\n"), Catch::Contains("m.mtl:2: 'x' is not a finite number"));
}

TEST_CASE("mtl: its terms become the materials that material.h states")
{
    CHECK_FALSE(only_material("Kd 0.5 0.5 0.5\n").specular);
    const Material plastic = only_material("Kd 0.5 0.5 0.5\nKs 0.5 0.5 0.5\nNs 98\nNi 1.33\n");
    CHECK(plastic.specular);
    CHECK(plastic.metalness == 0);
    CHECK_FALSE(plastic.rough_body);
    CHECK(static_cast<double>(plastic.index) == Approx(1.5));
    CHECK(static_cast<double>(plastic.alpha) == Approx(std::sqrt(0.02)));
    const Material physical = only_material("Kd 0.9 0.6 0.2\nPr 0.5\nPm 0.75\n");
    CHECK(static_cast<double>(physical.alpha) == Approx(0.25));
    CHECK(static_cast<double>(physical.metalness) == Approx(0.75));
    CHECK(physical.rough_body);
    CHECK(static_cast<double>(only_material("Ke 5 4 3\n").emission.g) == Approx(4));
    CHECK(only_material("Ke 5 4 3\n").emits());
    CHECK(static_cast<double>(only_material("d 0.25\n").opacity) == Approx(0.25));
    CHECK(static_cast<double>(only_material("Tr 0.25\n").opacity) == Approx(0.75));
}

TEST_CASE("mtl: Ks is the strength of the skin, also beside Pr, and without it Ni is what counts")
{
    CHECK_FALSE(only_material("Kd 0.6 0.6 0.6\nKs 0 0 0\nPr 1\n").specular);
    CHECK_FALSE(only_material("Kd 0.6 0.6 0.6\nKs 0 0 0\nPm 0\nmap_Pr t.png\n").specular);
    CHECK(only_material("Kd 0.6 0.6 0.6\nPr 1\n").specular);
    CHECK(static_cast<double>(only_material("Kd 0.6 0.6 0.6\nPr 1\nNi 1.33\n").index) == Approx(1.33));
    for (const float ks : {0.1f, 0.5f, 1.0f}) {
        const std::string number = std::to_string(ks);
        const Material m = only_material("Kd 0.6 0.6 0.6\nKs " + number + "\nPr 0.5\nNi 1.45\n");
        CHECK(static_cast<double>(dielectric_reflectance(1, m.index)) == Approx(0.08 * static_cast<double>(ks)));
    }
    CHECK(static_cast<double>(only_material("Ks 0.5 0.5 0.5\nNi 1.45\nillum 7\n").index) == Approx(1.45));
}

TEST_CASE("mtl: a black Kd under Ks is black plastic, unless illum 3 says that it is a mirror")
{
    const Material plastic = only_material("Kd 0 0 0\nKs 0.9 0.8 0.7\nNs 168\nillum 2\n");
    CHECK(plastic.specular);
    CHECK(plastic.metalness == 0);
    CHECK(is_black(plastic.base));
    const Material chrome = only_material("Kd 0 0 0\nKs 0.9 0.8 0.7\nNs 1000\nillum 3\n");
    CHECK(chrome.metalness == 1);
    CHECK(static_cast<double>(chrome.base.g) == Approx(0.8));
    // Blender writes illum 3 beside Pm and the metal's colour as Kd.
    CHECK(is_black(only_material("Kd 0 0 0\nKs 0.5 0.5 0.5\nPr 0.3\nPm 1\nillum 3\n").base));
}

TEST_CASE("mtl: without Kd a material is grey, or shows its picture, so it does with a black one")
{
    CHECK(only_material("Ns 10\n").base.r == 0.6f);
    CHECK(only_material("Ks 0.2 0.2 0.2\nNs 50\n").base.r == 0.6f);
    CHECK(only_material("Kd 0 0 0\n").base.r == 0);
    CHECK(only_material("map_Kd t.png\n").base.r == 1);
    CHECK(only_material("Kd 0 0 0\nmap_Kd t.png\n").base.r == 1);
}

TEST_CASE("mtl: words of colours and opacity that are not drawn cost their line, and other words a warning each")
{
    std::string warnings;
    CHECK(only_material("Kd xyz 0.2 0.1 0.05\n", &warnings).base.r == 0.6f);
    CHECK_THAT(warnings, Catch::Contains("m.mtl:2: 1 colour(s) are given as 'xyz'"));
    CHECK(only_material("Kd spectral x.rfl 1\nkd 0.25 0 0\nroughness 1\nroughness 2\n", &warnings).base.r == 0.25f);
    CHECK_THAT(warnings, Catch::Contains("'spectral'") && Catch::Contains("m.mtl:3: 1 line(s) write 'kd' for 'Kd'") &&
                             Catch::Contains("m.mtl:4: 2 line(s) begin with 'roughness'"));
    CHECK(only_material("d -halo 0.5\n", &warnings).opacity == 0.5f);
    CHECK_THAT(warnings, Catch::Contains("m.mtl:2: 1 opacities '-halo'"));
}

TEST_CASE("mtl: the alpha of map_Kd cuts out unless map_d or an alpha that says nothing")
{
    const auto opacity_of = [](const std::string& mtl, uint8_t a, uint8_t b) {
        const ScratchFolder folder;
        folder.write("m.mtl", "newmtl x\nmap_Kd t.png\n" + mtl);
        folder.write("t.png", testing::png({PNG_COLOR_TYPE_RGB_ALPHA, 8, false}, 2, 1, {9, 9, 9, a, 9, 9, 9, b}));
        return load(folder.write("s.obj", std::string("mtllib m.mtl\nusemtl x\n") + kCorners + "f 1 2 3\n"))
            .parts.materials[0]
            .maps.opacity.used();
    };
    CHECK(opacity_of("", 0, 255));
    CHECK_FALSE(opacity_of("", 255, 255));
    CHECK_FALSE(opacity_of("", 0, 0));
}

TEST_CASE("mtl: doubtful opacity and doubled names are named")
{
    std::string warnings;
    CHECK(only_material("d 1\nTr 1\n", &warnings).opacity == 1);
    CHECK_THAT(warnings, Catch::Contains("m.mtl:3: both 'd' and 'Tr'"));
    only_material("Tr 1\n", &warnings);
    CHECK_THAT(warnings, Catch::Contains("makes the material invisible"));
    CHECK(static_cast<double>(only_material("Kd 0.1 0.1 0.1\nnewmtl x\nKd 0.9 0.9 0.9\n", &warnings).base.r) ==
          Approx(0.1));
    CHECK_THAT(warnings, Catch::Contains("m.mtl:3: 1 material(s) have the name of an earlier one"));
    CHECK(static_cast<double>(only_material("Kd 0.1 0 0\nnewmtl\nKd 0.9 0 0\n", &warnings).base.r) == Approx(0.1));
    CHECK_THAT(warnings, Catch::Contains("m.mtl:3: 1 material(s) have no name"));
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
            const Loaded loaded = load(file);
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

TEST_CASE("obj: a library is read once, however often and by whatever name it is named")
{
    const testing::ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\nKd 2 0 0\n");
    std::filesystem::create_symlink("m.mtl", folder.at("link.mtl"));
    std::string obj;
    for (int k = 0; k < 2000; ++k) obj += "mtllib m.mtl\nmtllib ./m.mtl\nmtllib link.mtl\n";
    std::vector<std::string> warnings;
    read_obj(folder.write("s.obj", obj + kCorners + "usemtl x\nf 1 2 3\n"), warnings);
    REQUIRE(warnings.size() == 1);  // one for each time that the library is read
    CHECK_THAT(warnings[0], Catch::Contains("m.mtl:2") && Catch::Contains("out of range"));
}

TEST_CASE("obj: of many materials each face gets its own, of two with one name the first counts")
{
    constexpr uint32_t kCount = 20000;
    const testing::ScratchFolder folder;
    std::string obj = std::string("mtllib m.mtl\nmtllib n.mtl\n") + kCorners, mtl;
    for (uint32_t k = 0; k < kCount; ++k) {
        mtl += "newmtl m" + std::to_string(k) + "\nKd " + std::to_string(k % 100) + "e-2 0 0\n";
        obj += "usemtl m" + std::to_string(kCount - 1 - k) + "\nf 1 2 3\n";
    }
    folder.write("m.mtl", mtl);
    folder.write("n.mtl", "newmtl m0\nKd 1 1 1\n");
    std::vector<std::string> warnings;
    const SceneParts parts = read_obj(folder.write("s.obj", obj), warnings);
    REQUIRE(parts.materials.size() == kCount);
    for (uint32_t k = 0; k < kCount; ++k) {
        const Material& material = parts.materials[parts.mesh.materials[k]];
        REQUIRE(material.name == "m" + std::to_string(kCount - 1 - k));
        REQUIRE(static_cast<double>(material.base.r) == Approx((kCount - 1 - k) % 100 * 0.01).margin(1e-6));
    }
}

TEST_CASE("obj: materials that share a picture of heights share the normals made of it")
{
    const testing::ScratchFolder folder;
    std::string obj = std::string("mtllib m.mtl\nvt 0 0\n") + kCorners, mtl;
    for (int k = 0; k < 50; ++k) {
        const std::string name = std::to_string(k);
        mtl += "newmtl " + name + "\nbump -bm " + (k < 25 ? "1" : "2") + " h.png\n";
        obj += "usemtl " + name + "\nf 1/1 2/1 3/1\n";
    }
    folder.write("h.png", testing::rgb_png(2, {9, 9, 9, 50, 50, 50}));
    folder.write("m.mtl", mtl);
    std::vector<std::string> warnings;
    const SceneParts parts = read_obj(folder.write("s.obj", obj), warnings);
    CHECK(warnings.empty());
    CHECK(parts.textures.size() == 3);  // heights, and normals of two strengths
}

}  // namespace lumi::baker
