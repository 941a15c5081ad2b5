// SPDX-License-Identifier: MIT
// Good and hostile MTL files: the material that they state, or a message that names file, line and mend.
#include <png.h>
#include <catch2/catch.hpp>

#include "lumi/baker/scene.h"
#include "material/lobes.h"
#include "model/tiny_obj.h"
#include "support/obj_files.h"

namespace lumi::baker
{
namespace
{

using testing::kCorners;
using testing::load_obj_file;
using testing::LoadedObj;
using testing::ScratchFolder;

Material only_material(const std::string& mtl, std::string* warnings = nullptr)
{
    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\n" + mtl);
    const LoadedObj l =
        load_obj_file(folder.write("s.obj", std::string("mtllib m.mtl\nusemtl x\n") + kCorners + "f 1 2 3\n"));
    if (warnings) *warnings = l.warnings;
    REQUIRE(l.parts.materials.size() == 1);
    return l.parts.materials[0];
}

}  // namespace

TEST_CASE("mtl: missing and broken pictures are named, and the plain colour is used")
{
    std::string warnings;
    CHECK(only_material("Kd 0.2 0.3 0.4\nmap_Kd no.png\n", &warnings).maps.base.texture == kNoTexture);
    CHECK_THAT(warnings, Catch::Contains("m.mtl:3: 1 use(s) of the picture 'no.png', which is missing"));

    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\nmap_Kd bad.png\n");
    folder.write("bad.png", "\x89PNG\r\n\x1a\nrubbish");
    const LoadedObj l =
        load_obj_file(folder.write("s.obj", std::string("mtllib m.mtl\nusemtl x\n") + kCorners + "f 1 2 3\n"));
    CHECK_THAT(l.warnings,
               Catch::Contains("m.mtl:2: 1 use(s) of the picture") && Catch::Contains("take the plain number"));
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
    CHECK_THAT(warnings,
               Catch::Contains("m.mtl:2: 2 number(s) 'Kd' are out of range") && Catch::Contains("(first: 2)"));
    CHECK(static_cast<double>(only_material("Kd 0.25\n").base.b) == Approx(0.25));
    const Material brushed = only_material("Pr 0.5\nPm 1\naniso 3\nPs -1\n", &warnings);
    CHECK(brushed.anisotropy == 1);
    CHECK(brushed.sheen == 0);
    CHECK_THAT(warnings, Catch::Contains("m.mtl:4: 1 number(s) 'aniso' are out of range") &&
                             Catch::Contains("m.mtl:5: 1 number(s) 'Ps' are out of range"));
    CHECK_THROWS_WITH(only_material("anisor x\n"), Catch::Contains("m.mtl:2: 'x' is not a finite number"));
}

TEST_CASE("mtl: what many materials have wrong costs one warning with their count")
{
    const ScratchFolder folder;
    const std::string wrong = "Ks 2 2 2\nmap_Kd no.png\nd 0\n";
    folder.write("m.mtl", "newmtl x\n" + wrong + "newmtl y\n" + wrong);
    const LoadedObj l = load_obj_file(folder.write("s.obj", std::string("mtllib m.mtl\n") + kCorners +
                                                                "usemtl x\nf 1 2 3\nusemtl y\nf 1 2 3\n"
                                                                "usemtl lost\nf 1 2 3\nusemtl none\nf 1 2 3\n"));
    CHECK_THAT(l.warnings, Catch::Contains("m.mtl:2: 6 number(s) 'Ks' are out of range and are clamped") &&
                               Catch::Contains("m.mtl:3: 2 use(s) of the picture 'no.png'") &&
                               Catch::Contains("m.mtl:4: 2 material(s) are invisible by 'd 0'") &&
                               Catch::Contains("2 material(s) are not defined"));
    CHECK(std::count(l.warnings.begin(), l.warnings.end(), '\n') == 4);
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

TEST_CASE("mtl: a word in other capitals is read, and named unless both spellings are MTL's")
{
    std::string warnings;
    CHECK(only_material("KD 0.25 0 0\n", &warnings).base.r == 0.25f);
    CHECK_THAT(warnings, Catch::Contains("m.mtl:2: 1 line(s) write 'KD' for 'Kd'"));
    only_material("MAP_BUMP\n", &warnings);
    CHECK_THAT(warnings, Catch::Contains("m.mtl:2: 1 line(s) write 'MAP_BUMP' for 'map_bump'"));
    only_material("map_Bump\nmap_bump\nbump\n", &warnings);
    CHECK_THAT(warnings, !Catch::Contains("line(s) write"));
}

TEST_CASE("mtl: of the words for bump maps map_Bump counts, whatever the order of their lines")
{
    for (const char* order : {"map_Bump c.png\nbump a.png\nmap_bump b.png\n", "bump a.png\nmap_Bump c.png\n"}) {
        std::string warnings;
        only_material(order, &warnings);
        CHECK_THAT(warnings, Catch::Contains("'c.png'") && !Catch::Contains("'a.png'") && !Catch::Contains("'b.png'"));
    }
}

TEST_CASE("mtl: options of pictures may have fewer numbers than MTL says, or senseless ones")
{
    const ScratchFolder folder;
    folder.write("t.png", testing::kRedPixel);
    const auto slot_of = [&](const std::string& options) {
        folder.write("m.mtl", "newmtl x\nmap_Kd " + options + " t.png\n");
        return load_obj_file(folder.write("s.obj", std::string("mtllib m.mtl\nusemtl x\n") + kCorners + "f 1 2 3\n"))
            .parts.materials[0]
            .maps.base;
    };
    CHECK(slot_of("-s 2 -o 0.5").scale.x == 2);
    CHECK(slot_of("-s 2 -o 0.5").scale.y == 1);
    CHECK(slot_of("-s 2 -o 0.5").offset.x == 0.5f);
    CHECK(slot_of("-o 1e9 0.25 -clamp on -mm 1 -texres 512").offset.x == 0);
    CHECK(slot_of("-o 1e9 0.25 -clamp on -mm 1 -texres 512").offset.y == 0.25f);
    CHECK(slot_of("-s 25e-2 1 1 -cc a -type sphere").scale.x == 0.25f);
    CHECK(slot_of("-s 2 2 2 -o 1 1 1 t.png\nmap_Kd").scale.x == 1);
}

TEST_CASE("mtl: words that tinyobjloader does not know have their numbers")
{
    MtlMaterial m;
    m.numbers = {{"Kd", {}}, {"Pzz", {}}, {"Pz", {}}};
    read_mtl_text("newmtl x\nKd 0.1 0.2 0.3\nPzz 0.5 0.25 1\nPz 0.75\n", m);
    CHECK(m.colour("Pzz").g == 0.25f);
    CHECK(m.number("Pz", 0) == 0.75f);
    CHECK(m.colour("Kd").b == 0.3f);
}

TEST_CASE("mtl: a line of very many options is read once")
{
    std::string line = "map_Kd";  // half a million, of which each was looked for in all that follows
    for (int k = 0; k < 500000; ++k) line += " -clamp on";
    std::string warnings;
    only_material(line + " t.png\n", &warnings);
    CHECK_THAT(warnings, Catch::Contains("t.png"));
}

TEST_CASE("mtl: the alpha of map_Kd cuts out unless map_d or an alpha that says nothing")
{
    const auto opacity_of = [](const std::string& mtl, uint8_t a, uint8_t b) {
        const ScratchFolder folder;
        folder.write("m.mtl", "newmtl x\nmap_Kd t.png\n" + mtl);
        folder.write("t.png", testing::png({PNG_COLOR_TYPE_RGB_ALPHA, 8, false}, 2, 1, {9, 9, 9, a, 9, 9, 9, b}));
        return load_obj_file(folder.write("s.obj", std::string("mtllib m.mtl\nusemtl x\n") + kCorners + "f 1 2 3\n"))
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
    CHECK_THAT(warnings, Catch::Contains("m.mtl:3: 1 material(s) have both 'd' and 'Tr'"));
    CHECK(only_material("Tr 1\nnewmtl other\nd 1\n", &warnings).opacity == 0);
    CHECK_THAT(warnings, Catch::Contains("m.mtl:2: 1 material(s) are invisible by 'Tr 1'"));
    CHECK(only_material("Tr 1\n", &warnings).opacity == 1);
    CHECK_THAT(warnings, Catch::Contains("m.mtl:2: 1 material(s), all of the file, would be invisible by 'Tr 1'"));
    CHECK(static_cast<double>(only_material("Kd 0.1 0.1 0.1\nnewmtl x\nKd 0.9 0.9 0.9\n", &warnings).base.r) ==
          Approx(0.1));
    CHECK_THAT(warnings, Catch::Contains("m.mtl:3: 1 material(s) have the name of an earlier one"));
    CHECK(static_cast<double>(only_material("Kd 0.1 0 0\nnewmtl\nKd 0.9 0 0\n", &warnings).base.r) == Approx(0.1));
    CHECK_THAT(warnings, Catch::Contains("m.mtl:3: 1 material(s) have no name"));
}

}  // namespace lumi::baker
