// SPDX-License-Identifier: MIT
// Hostile glTF files: a message that names the file and the mend, never a crash.
#include <catch2/catch.hpp>

#include "lumi/baker/scene.h"
#include "model/gltf/reader.h"
#include "support/gltf_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using testing::GltfMaker;
using testing::ScratchFolder;
using testing::square;

void check_gltf_refused(const std::string& bytes, const std::string& what, const char* name = "m.glb")
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    CHECK_THROWS_WITH(read_gltf(folder.write(name, bytes), warnings),
                      Catch::Contains(std::string(name) + ": ") && Catch::Contains(what) && Catch::Contains("; "));
}

std::string glb_with(GltfMaker maker, const std::string& members)
{
    maker.add(members);
    return maker.glb();
}

// A triangle whose positions are an accessor of these members.
std::string glb_of_positions(const std::string& accessor)
{
    GltfMaker maker;
    maker.view(std::string(36, '\0'));
    maker.accessor(accessor);
    maker.add("\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}]");
    return maker.glb();
}

// What is read of a hostile file that is none the less a model.
struct BoundedGltf {
    SceneParts parts;
    std::vector<std::string> warnings;
};

BoundedGltf read_bounded(const GltfMaker& maker)
{
    const ScratchFolder folder;
    BoundedGltf read;
    read.parts = read_gltf(folder.write("m.glb", maker.glb()), read.warnings);
    return read;
}

}  // namespace

TEST_CASE("glTF: what is required and not drawn is refused by its name, with the way out")
{
    const auto requiring = [](const std::string& extension) {
        return glb_with(square(), "\"extensionsRequired\":[\"" + extension + "\"]");
    };
    check_gltf_refused(requiring("KHR_draco_mesh_compression"), "Draco");
    check_gltf_refused(requiring("EXT_meshopt_compression"), "meshopt");
    check_gltf_refused(requiring("KHR_texture_basisu"), "KTX2");
    check_gltf_refused(requiring("EXT_texture_webp"), "WebP");
    check_gltf_refused(requiring("ACME_wobble"), "ACME_wobble");
    GltfMaker webp = square("\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}");
    webp.add("\"textures\":[{\"extensions\":{\"EXT_texture_webp\":{\"source\":0}}}],\"images\":[{\"uri\":\"p.webp\"}]");
    check_gltf_refused(webp.glb(), "WebP");
    check_gltf_refused("{\"asset\":{\"version\":\"1.0\"}}", "glTF 1.0", "m.gltf");
    check_gltf_refused("glTF" + std::string("\1\0\0\0\x14\0\0\0\0\0\0\0\0\0\0\0", 16), "glTF 1.0");
    check_gltf_refused("{\"meshes\":{}}", "glTF 1.0", "m.gltf");
    check_gltf_refused(std::string("\x89PNG\0\0", 6), "neither glTF nor GLB");
    check_gltf_refused("garbage", "neither glTF nor GLB");
    check_gltf_refused("", "neither glTF nor GLB", "m.gltf");
    check_gltf_refused("{\"asset\":", "cut short", "m.gltf");
}

TEST_CASE("glTF: a GLB that is cut anywhere is refused")
{
    const std::string whole = square("\"name\":\"x\"").glb();
    for (size_t size = 0; size < whole.size(); ++size) {
        INFO(size << " of " << whole.size() << " bytes");
        check_gltf_refused(whole.substr(0, size), "");
    }
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    CHECK(read_gltf(folder.write("m.glb", whole), warnings).mesh.triangle_count() == 2);
}

TEST_CASE("glTF: any changed byte gives a model or a message")
{
    const std::string whole = square("\"pbrMetallicRoughness\":{\"metallicFactor\":0.5}").glb();
    const ScratchFolder folder;
    for (size_t k = 0; k < whole.size(); ++k) {
        for (const char mask : {'\1', '\x40', '\x80'}) {
            std::string bytes = whole;
            bytes[k] = static_cast<char>(bytes[k] ^ mask);
            std::vector<std::string> warnings;
            try {
                read_gltf(folder.write("m.glb", bytes), warnings);
            } catch (const SceneError& e) {
                CHECK_THAT(e.what(), Catch::Contains("m.glb: ") && Catch::Contains("; "));
            }
        }
    }
}

TEST_CASE("glTF: nodes below themselves, or below two nodes, are refused")
{
    const auto with_nodes = [](const std::string& nodes) {
        return glb_with({}, "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[" + nodes + "]");
    };
    check_gltf_refused(with_nodes("{\"children\":[0]}"), "node 0");
    check_gltf_refused(with_nodes("{\"children\":[1]},{\"children\":[0]}"), "node 0");
    check_gltf_refused(with_nodes("{\"children\":[1,1]},{}"), "node 1");
    check_gltf_refused(with_nodes("{\"children\":[7]}"), "node 7");
}

TEST_CASE("glTF: accessors that reach beyond their buffers, or claim what the file cannot hold, are refused")
{
    const std::string rest = ",\"componentType\":5126,\"type\":\"VEC3\",\"count\":";
    check_gltf_refused(glb_of_positions("\"bufferView\":0" + rest + "4"), "beyond");
    check_gltf_refused(glb_of_positions("\"bufferView\":0,\"byteOffset\":4" + rest + "3"), "beyond");
    check_gltf_refused(glb_of_positions("\"bufferView\":0" + rest + "1000000000"), "beyond");
    check_gltf_refused(glb_of_positions("\"bufferView\":0" + rest + "4294967297"), "beyond");
    check_gltf_refused(glb_of_positions("\"bufferView\":3" + rest + "3"), "buffer view 3");
    check_gltf_refused(glb_of_positions(rest.substr(1) + "1000000000"), "without any bytes");
    check_gltf_refused(
        glb_of_positions(rest.substr(1) + "3,\"sparse\":{\"count\":1000000000,\"indices\":{\"bufferView\":0,"
                                          "\"componentType\":5125},\"values\":{\"bufferView\":0}}"),
        "beyond");
}

TEST_CASE("glTF: numbers that are not finite, or place a mesh nowhere, are refused")
{
    GltfMaker maker;
    const std::string p = std::to_string(maker.vec3({0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0}));
    maker.add("\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + p + "}}]}]");
    check_gltf_refused(maker.glb(), "not finite");
    check_gltf_refused(square("", "\"translation\":[NaN,0,0]").glb(), "");
    check_gltf_refused(square("", "\"translation\":[1e999,0,0]").glb(), "");
    check_gltf_refused(square("", "\"scale\":[1e300,1e300,1e300]").glb(), "places its mesh");
    check_gltf_refused(square("", "\"scale\":[0,0,0]").glb(), "no triangle");
}

TEST_CASE("glTF: a chain of very many nodes is read at once")
{
    constexpr size_t kNodes = 200000;  // 2 * 10^10 pairs of a node and one above it
    std::string nodes;
    for (size_t k = 1; k < kNodes; ++k) nodes += "{\"children\":[" + std::to_string(k) + "]},";
    GltfMaker maker;
    const std::string p = std::to_string(maker.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    maker.add("\"nodes\":[" + nodes + "{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + p +
              "}}]}]");
    const SceneParts parts = read_bounded(maker).parts;
    REQUIRE(parts.named.size() == kNodes);
    CHECK(std::all_of(parts.named.begin(), parts.named.end(),
                      [](const NamedPart& part) { return part.first == 0 && part.end == 1; }));
}

TEST_CASE("glTF: a JSON that nests too deeply, or claims too much, is refused before it is parsed")
{
    GltfMaker deep = square();
    deep.add("\"extras\":" + std::string(100000, '[') + std::string(100000, ']'));
    check_gltf_refused(deep.glb(), "nests too deeply");
    GltfMaker broad = square();
    std::string many;
    for (size_t k = 0; k < 4'000'001; ++k) many += "{},";
    broad.add("\"extras\":[" + many + "{}]");
    check_gltf_refused(broad.glb(), "parts");
    check_gltf_refused(std::string((size_t{1} << 28) + 1, ' '), "bytes, at most", "m.gltf");
}

}  // namespace lumi::baker
