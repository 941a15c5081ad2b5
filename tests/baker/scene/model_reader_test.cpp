// SPDX-License-Identifier: MIT
// Which reader gets a file, and what other formats are told.
#include "scene/model_reader.h"

#include <catch2/catch.hpp>

#include "lumi/baker/scene.h"
#include "support/facet_bytes.h"
#include "support/gltf_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using namespace std::string_literals;
using testing::ScratchFolder;

void check_told(const std::string& name, const std::string& bytes, const std::string& format, const std::string& way)
{
    INFO(name);
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    CHECK_THROWS_WITH(read_model(folder.write(name, bytes), warnings),
                      Catch::Contains(name + ": this is " + format) && Catch::Contains("; ") && Catch::Contains(way));
}

struct Known {
    std::string end, name, way, bytes;
};

// With the marks that files of the format have.
const std::vector<Known> kKnown = {
    {".fbx", "FBX", "assimp export", "Kaydara FBX Binary  \0\x1A\0"s},
    {".fbx", "FBX", "assimp export", "; FBX 7.3.0 project file\n"},
    {".dae", "COLLADA", "assimp export", "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"x\">"},
    {".3ds", "3D Studio", "assimp export", "MM\x20\0\0\0\x02\0\x0A\0\0\0\3\0\0\0"s},
    {".blend", "Blender's own", "glTF 2.0", "BLENDER-v304"},
    {".usda", "USD", "Blender from blender.org", "#usda 1.0\n"},
    {".usdc", "USD", "Blender from blender.org", "PXR-USDC\0\0"s},
    {".usdz", "USDZ", "Blender from blender.org", "PK\3\4\x0A\0scene.usdc"s},
    {".3mf", "3MF", "assimp export", "PK\3\4\x0A\0[Content_Types].xml...3D/3dmodel.model"s},
    {".step", "STEP", "FreeCAD", "ISO-10303-21;\nHEADER;\n"},
    {".ifc", "IFC", "FreeCAD", "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC2X3'));\n"},
    {".iges", "IGES", "FreeCAD", std::string(72, ' ') + "S      1\n"},
    {".off", "OFF", "assimp export", "OFF\n8 6 0\n"},
    {".x3d", "X3D", "assimp export", "\xEF\xBB\xBF<?xml version=\"1.0\"?><X3D version=\"3.0\">"},
    {".wrl", "VRML", "Blender", "#VRML V2.0 utf8\n"},
    {".abc", "Alembic", "Blender from blender.org", "Ogawa\xFF\0\1"s},
    {".amf", "AMF", "assimp export", "<?xml?><amf unit=\"mm\">"},
    {".pcd", "a point cloud", "MeshLab", "# .PCD v.7\n"},
    {".splat", "a cloud of Gaussian splats", "MeshLab", ""},
};

}  // namespace

TEST_CASE("models: other formats are refused by their own name, with the way out, by name and by content")
{
    for (const Known& k : kKnown) {
        check_told("a" + k.end, k.bytes, k.name, k.way);
        check_told("a" + k.end, "?", k.name, k.way);
        if (!k.bytes.empty()) check_told("a.obj", k.bytes, k.name, k.way);
    }
    check_told("A.FBX", "?", "FBX", "A.FBX");
    check_told("a.obj", "Kaydara FBX Binary  ", "FBX, whatever its name says", "let its name end in .fbx");
}

TEST_CASE("models: archives, pictures, web pages and fields are told what they are")
{
    check_told("a.obj", "PK\3\4abc", "a ZIP archive", "unpack it");
    check_told("a.obj", "\x1F\x8B\x08", "packed by gzip", "unpack it");
    check_told("a.glb", "<!DOCTYPE html><html>", "a web page", "download");
    check_told("a.ply", "\x89PNG\r\n", "a picture", "name the model");
    check_told("a.obj", "\x89LUMI\r\n", "a field already", "lumi view");
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    CHECK_THROWS_WITH(read_model(folder.write("a.stl", "version https://git-lfs.github.com/spec/v1\n"), warnings),
                      Catch::Contains("git lfs pull"));
}

TEST_CASE("models: what is read is read under any name")
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    const auto triangles = [&](const std::string& name, const std::string& bytes) {
        return read_model(folder.write(name, bytes), warnings).mesh.triangle_count();
    };
    for (const char* name : {"m.obj", "m.fbx", "m.glb", "m"}) {
        CHECK(triangles(name, testing::square().glb()) == 2);
        CHECK(triangles(name, testing::binary_stl()) == 4);
        CHECK(triangles(name, testing::text_stl()) == 4);
        CHECK(triangles(name, testing::text_ply()) == 6);
    }
    CHECK(triangles("m.PLY", testing::binary_ply<int>(true, "int")) == 6);
    CHECK(triangles("m.txt", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n") == 1);
    CHECK(warnings.empty());
}

}  // namespace lumi::baker
