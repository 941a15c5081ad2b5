// SPDX-License-Identifier: MIT
#include "model/readers.h"

#include <catch2/catch.hpp>

#include "lumi/baker/scene.h"
#include "support/facet_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using testing::ScratchFolder;

SceneParts load_ply(const std::string& bytes, std::string* said = nullptr)
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    SceneParts parts = read_ply(folder.write("m.ply", bytes), warnings);
    if (said)
        for (const std::string& w : warnings) *said += w + "\n";
    return parts;
}

void check_ply_refused(const std::string& bytes, const std::string& what)
{
    CHECK_THROWS_WITH(load_ply(bytes), Catch::Contains("m.ply") && Catch::Contains(what) && Catch::Contains("; "));
}

std::string with(std::string text, const std::string& from, const std::string& to)
{
    const size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

void check_pyramid(const std::string& bytes)
{
    std::string said;
    const SceneParts parts = load_ply(bytes, &said);
    CHECK(said.empty());
    CHECK(parts.mesh.triangle_count() == 6);
    REQUIRE(parts.textures.size() == 1);
    REQUIRE(parts.materials.size() == 1);
    CHECK(parts.materials[0].maps.base.used());
    CHECK(parts.textures[0].rgb[0] == 255);
    CHECK(parts.textures[0].rgb[1] == 0);
}

}  // namespace

TEST_CASE("PLY: text, both orders of bytes, and every whole type of indices are the same body")
{
    check_pyramid(testing::text_ply());
    for (const bool big : {false, true}) {
        check_pyramid(testing::binary_ply<int8_t>(big, "char"));
        check_pyramid(testing::binary_ply<uint8_t>(big, "uint8"));
        check_pyramid(testing::binary_ply<int16_t>(big, "short"));
        check_pyramid(testing::binary_ply<uint16_t>(big, "uint16"));
        check_pyramid(testing::binary_ply<int32_t>(big, "int32"));
        check_pyramid(testing::binary_ply<uint32_t>(big, "uint"));
    }
}

TEST_CASE("PLY: colours of a display become light, and colours that are floats run to 1")
{
    std::string grey = testing::text_ply();
    for (int k = 0; k < 5; ++k) grey = with(grey, " 255 0 0\n", " 188 188 188\n");
    CHECK(load_ply(grey).textures[0].rgb[0] == 188);  // as a picture it is encoded again
    std::string floats = testing::text_ply();
    for (const char* name : {"red", "green", "blue"})
        floats = with(floats, std::string("uchar ") + name, std::string("float ") + name);
    for (int k = 0; k < 5; ++k) floats = with(floats, " 255 0 0\n", " 1.0 0.5 0\n");
    CHECK(load_ply(floats).textures[0].rgb[0] == 255);
    CHECK(load_ply(floats).textures[0].rgb[1] == 128);
}

TEST_CASE("PLY: faces may come before their vertices, and other elements cost one warning")
{
    const std::string text =
        "ply\nformat ascii 1.0\nelement edge 2\nproperty int a\nproperty list int int b\nelement face 1\n"
        "property list uint8 int vertex_index\nelement vertex 3\nproperty double x\nproperty double y\n"
        "property double z\nend_header\n1 0\n1 2 3 4\n3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n";
    std::string said;
    CHECK(load_ply(text, &said).mesh.triangle_count() == 1);
    CHECK(said.find("2 element(s) 'edge' are left out") != std::string::npos);
}

TEST_CASE("PLY: normals of the file shade, and vertices far from the origin keep their shape")
{
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
        "property list uint8 int vertex_index\nend_header\n"
        "4500000.125 600000.5 12 0 0 2\n4500001.125 600000.5 12 0 0 2\n4500000.125 600001.5 12 1 0 0\n3 0 1 2\n";
    const SceneParts parts = load_ply(text);
    CHECK(parts.mesh.normals[0].z == 1);
    CHECK(parts.mesh.normals[static_cast<size_t>(parts.mesh.shading[0][2])].x == 1);
    CHECK(static_cast<double>(parts.mesh.area(0)) == Approx(0.5));
    CHECK(parts.origin[0] + static_cast<double>(parts.mesh.positions[0].x) == 4500000.125);
}

TEST_CASE("PLY: numbers of a text beyond those of its heading are left out, with their lines' count")
{
    std::string said, text = testing::text_ply();
    size_t line = text.find('\n', text.find("end_header"));
    while ((line = text.find('\n', line + 1)) != std::string::npos) text.insert(line, " 7 8"), line += 4;
    CHECK(load_ply(text, &said).mesh.triangle_count() == 6);
    CHECK_THAT(said, Catch::Contains("line(s) have more numbers than the heading says"));
}

TEST_CASE("PLY: a picture that a comment names costs a warning, and z is up in what Blender wrote")
{
    std::string said;
    const auto commented = [](const std::string& words) {
        return with(testing::text_ply(), "element", "comment " + words + "\nelement");
    };
    CHECK_FALSE(load_ply(commented("TextureFile wood.png"), &said).up);
    CHECK_THAT(said, Catch::Contains("'wood.png'"));
    CHECK(load_ply(commented("Created by Blender 3.4.1 - www.blender.org")).up == UpAxis::z);
    CHECK(load_ply(commented("Created in Blender version 4.2.0")).up == UpAxis::z);
}

TEST_CASE("PLY: points without faces are refused by their name")
{
    check_ply_refused(with(testing::ply_heading("ascii"), "element face 5", "element face 0"), "a cloud of 5 points");
    check_ply_refused("ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\nproperty float f_dc_0\nend_header\n",
                      "Gaussian splats");
    check_ply_refused("ply\nformat ascii 1.0\nend_header\n", "no face");
}

TEST_CASE("PLY: a file that is cut anywhere is refused, or says that its last number may be cut")
{
    for (const std::string& whole :
         {testing::binary_ply<uint8_t>(true, "uchar"), testing::binary_ply<int>(false, "int")})
        for (size_t size = 0; size < whole.size(); ++size) check_ply_refused(whole.substr(0, size), "");
    const std::string text = testing::text_ply();
    for (size_t size = 0; size + 1 < text.size(); ++size) {
        INFO(size);
        check_ply_refused(text.substr(0, size), "");
    }
    std::string said;
    load_ply(text.substr(0, text.size() - 1), &said);
    CHECK_THAT(said, Catch::Contains("no line end"));
}

TEST_CASE("PLY: what claims a billion elements, or an endless list, is refused before it takes memory")
{
    const std::string text = testing::text_ply(), binary = testing::binary_ply<uint32_t>(false, "uint");
    for (const std::string& whole : {text, binary}) {
        check_ply_refused(with(whole, "vertex 5", "vertex 1000000000"), "'vertex' are 1000000000");
        check_ply_refused(with(whole, "face 5", "face 18446744073709551615"), "no number of elements");
        check_ply_refused(with(whole, "face 5", "face 9223372036854775807"), "cut short");
    }
    check_ply_refused(with(with(text, "list uchar", "list uint"), "3 0 1 4", "4000000000 0 1 4"),
                      "4000000000 numbers follow");
    check_ply_refused(with(text, "3 0 1 4", "1" + std::string(60, '0') + " 0 1 4"), "a list has 1e+60 numbers");
    CHECK(
        load_ply(with(text, "element vertex", "element nothing 1000000000000\nelement vertex")).mesh.triangle_count() ==
        6);
}

TEST_CASE("PLY: numbers that are none, and indices of no vertex, are refused with their line")
{
    const std::string text = testing::text_ply();
    check_ply_refused(with(text, "1.000000 1.000000 0.000000 255", "1.000000 nan 0.000000 255"), "vertex 0 has");
    check_ply_refused(with(text, "3 0 1 4", "3 0 1 5"), "vertex 5");
    check_ply_refused(with(text, "3 0 1 4", "3 0 -1 4"), "vertex -1");
    check_ply_refused(with(text, "3 0 1 4", "3 0 1.5 4"), "'1.5' is no whole number");
    check_ply_refused(with(text, "property float x", "property half x"), "m.ply:5: 'half'");
    check_ply_refused(with(text, "ascii 1.0", "ascii 2.0"), "ascii 2.0");
    check_ply_refused(with(text, "float z", "float height"), "no x, y and z");
}

}  // namespace lumi::baker
