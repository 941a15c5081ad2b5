// SPDX-License-Identifier: MIT
// From the names in an OBJ file to the material files and pictures that they mean.
#include <catch2/catch.hpp>

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

}  // namespace

TEST_CASE("obj: files are found in another letter case, in quotes, or by the OBJ's own name, and a warning says so")
{
    const ScratchFolder folder;
    folder.write("M.MTL", "newmtl x\nmap_Kd \"Two Words.PNG\"\n");
    folder.write("two words.png", kRedPixel);
    const std::string face = std::string(kCorners) + "usemtl x\nf 1 2 3\n";
    const LoadedObj l = load_obj_file(folder.write("s.obj", "mtllib m.mtl\n" + face));
    CHECK(l.parts.textures.size() == 1);
    CHECK_THAT(l.warnings, Catch::Contains("s.obj:1: 1 material file(s) are found by another letter case") &&
                               Catch::Contains("take 'two words.png' for it"));
    folder.write("own.mtl", "newmtl x\nKd 0.25 0 0\n");
    const LoadedObj own = load_obj_file(folder.write("own.obj", "mtllib lost.mtl\n" + face));
    CHECK(own.parts.materials[0].base.r == 0.25f);
    CHECK_THAT(own.warnings, Catch::Contains("lost.mtl' is missing") && Catch::Contains("by the OBJ's own name"));
}

TEST_CASE("obj: a missing material file and an undefined material are named, and drawn grey")
{
    const LoadedObj l = load_obj(std::string("mtllib lost one.mtl\n") + kCorners + "usemtl brick wall\nf 1 2 3\n");
    CHECK_THAT(l.warnings, Catch::Contains("scene.obj:1: the material file 'lost one.mtl' is missing"));
    CHECK_THAT(l.warnings,
               Catch::Contains("scene.obj:6: 1 material(s) are not defined") && Catch::Contains("(first: brick wall)"));
    REQUIRE(l.parts.materials.size() == 1);
    CHECK(static_cast<double>(l.parts.materials[0].base.r) == Approx(0.6));
}

TEST_CASE("obj: names with blanks, backslashes and Windows line ends")
{
    const ScratchFolder folder;
    folder.write("sub dir/my mat.mtl", "newmtl red paint\r\nKd 1 1 1\r\nmap_Kd tex dir\\a red.png\r\n");
    folder.write("sub dir/tex dir/a red.png", kRedPixel);
    const LoadedObj l =
        load_obj_file(folder.write("my scene.obj", std::string("mtllib sub dir\\my mat.mtl\r\n") + kCorners +
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
    const LoadedObj l = load_obj_file(
        folder.write("s.obj", std::string("mtllib m.mtl\nusemtl x\nvt 0 0\n") + kCorners + "f 1/1 2/1 3/1\n"));
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
    const LoadedObj l =
        load_obj_file(folder.write("s.obj", std::string("mtllib a.mtl b.mtl\nmtllib c.mtl\n") + kCorners +
                                                "usemtl c\nf 1 2 3\nusemtl a\nf 1 3 4\nusemtl b\nf 1 2 4\n"));
    CHECK(l.warnings.empty());
    REQUIRE(l.parts.materials.size() == 3);
    for (size_t t = 0; t < 3; ++t) {
        const double expected[] = {0.3, 0.1, 0.2};
        CHECK(static_cast<double>(l.parts.materials[l.parts.mesh.materials[t]].base.g) == Approx(expected[t]));
    }
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
