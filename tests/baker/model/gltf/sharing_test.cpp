// SPDX-License-Identifier: MIT
// glTF files whose primitives share vertices, whose nodes share meshes, or whose materials are alike.
#include <catch2/catch.hpp>

#include "lumi/baker/scene.h"
#include "material/texture_slot.h"
#include "model/gltf/reader.h"
#include "support/gltf_bytes.h"
#include "support/picture_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using testing::GltfMaker;
using testing::ScratchFolder;

SceneParts read_sharing(const GltfMaker& maker)
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    SceneParts parts = read_gltf(folder.write("m.glb", maker.glb()), warnings);
    CHECK(warnings.empty());
    return parts;
}

void check_sharing_refused(const GltfMaker& maker, const std::string& what)
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    CHECK_THROWS_WITH(read_gltf(folder.write("m.glb", maker.glb()), warnings),
                      Catch::Contains("m.glb: ") && Catch::Contains(what) && Catch::Contains("; "));
}

// `text` so many times, with commas between.
std::string repeated(const std::string& text, size_t count)
{
    std::string list = text;
    for (size_t k = 1; k < count; ++k) list += "," + text;
    return list;
}

// A row of vertices of which any three neighbours are a triangle: x, and y that goes up and down.
std::string zigzag(GltfMaker& maker, size_t vertices)
{
    std::vector<float> positions;
    for (size_t k = 0; k < vertices; ++k)
        positions.insert(positions.end(), {static_cast<float>(k), static_cast<float>(k % 2), 0});
    return std::to_string(maker.vec3(positions));
}

bool same_colour(const Rgb& a, const Rgb& b)
{
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

constexpr size_t kShared = 1000;

// Two primitives with a triangle each, of a row of vertices that is red in its first half and blue in its second.
GltfMaker red_and_blue(const std::string& material)
{
    GltfMaker maker;
    const std::string positions = zigzag(maker, kShared);
    std::vector<float> colours;
    for (size_t k = 0; k < kShared; ++k)
        colours.insert(colours.end(), {k < kShared / 2 ? 1.0f : 0.0f, 0, k < kShared / 2 ? 0.0f : 1.0f});
    const std::string attributes = "{\"attributes\":{\"POSITION\":" + positions +
                                   ",\"COLOR_0\":" + std::to_string(maker.vec3(colours)) +
                                   "},\"material\":0,\"indices\":";
    const std::string red = std::to_string(maker.indices({0, 1, 2})),
                      blue = std::to_string(maker.indices({702, 700, 701}));
    maker.add("\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[" + attributes + red + "}," + attributes + blue +
              "}]}]");
    maker.add("\"materials\":[{" + material + "}]");
    return maker;
}

}  // namespace

TEST_CASE("glTF: primitives that share vertices take those that they use, and their colours alone")
{
    GltfMaker maker = red_and_blue("\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}");
    const std::string view = std::to_string(maker.view(testing::rgb_png(1, {255, 255, 255})));
    maker.add("\"images\":[{\"bufferView\":" + view + ",\"mimeType\":\"image/png\"}],\"textures\":[{\"source\":0}]");
    for (const GltfMaker& file : {maker, red_and_blue("\"name\":\"plain\"")}) {
        const SceneParts parts = read_sharing(file);
        REQUIRE(parts.mesh.triangle_count() == 2);
        REQUIRE(parts.mesh.positions.size() == 6);
        CHECK(parts.mesh.position(0, 0).x == 0);
        CHECK(parts.mesh.position(1, 0).x == 702);
        CHECK(parts.mesh.position(1, 1).x == 700);
        CHECK(same_colour(parts.materials[parts.mesh.materials[0]].base, {1, 0, 0}));
        CHECK(same_colour(parts.materials[parts.mesh.materials[1]].base, {0, 0, 1}));
    }
}

TEST_CASE("glTF: very many primitives may share very many vertices")
{
    constexpr size_t kPrimitives = 5000, kVertices = 100000;  // 5 * 10^8 vertices if each took all of them
    GltfMaker maker;
    const std::string positions = zigzag(maker, kVertices);
    const std::string ends = std::to_string(maker.numbers<uint32_t>({0, 1, kVertices - 1}, 5125, "SCALAR", 3));
    maker.add("\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[" +
              repeated("{\"attributes\":{\"POSITION\":" + positions + "},\"indices\":" + ends + "}", kPrimitives) +
              "]}]");
    const SceneParts parts = read_sharing(maker);
    CHECK(parts.mesh.triangle_count() == kPrimitives);
    CHECK(parts.mesh.positions.size() == 3 * kPrimitives);
    CHECK(parts.mesh.position(kPrimitives - 1, 2).x == static_cast<float>(kVertices - 1));
}

TEST_CASE("glTF: very many primitives that share a long sparse accessor are refused")
{
    constexpr size_t kReplaced = 20000, kPrimitives = 5001;  // more than 10^8 replacements
    GltfMaker maker;
    std::vector<uint16_t> places(kReplaced);
    for (size_t k = 0; k < kReplaced; ++k) places[k] = static_cast<uint16_t>(k);
    const std::string values = zigzag(maker, kReplaced);
    maker.indices(places);
    const std::string sparse = std::to_string(maker.accessor(
        "\"componentType\":5126,\"type\":\"VEC3\",\"count\":" + std::to_string(kReplaced) +
        ",\"sparse\":{\"count\":" + std::to_string(kReplaced) +
        ",\"indices\":{\"bufferView\":1,\"componentType\":5123},\"values\":{\"bufferView\":" + values + "}}"));
    const std::string first = std::to_string(maker.indices({0, 1, 2}));
    const std::string primitive = "{\"attributes\":{\"POSITION\":" + sparse + "},\"indices\":" + first + "}";
    GltfMaker few = maker;
    few.add("\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[" + repeated(primitive, 2) + "]}]");
    CHECK(read_sharing(few).mesh.positions.size() == 6);
    maker.add("\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[" + repeated(primitive, kPrimitives) + "]}]");
    check_sharing_refused(maker, "sparse");
}

TEST_CASE("glTF: triangles without an area count as triangles where there are too many")
{
    constexpr size_t kTriangles = 1'000'000, kNodes = 101;
    GltfMaker maker;
    const std::string p = std::to_string(maker.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    std::vector<uint16_t> corners(3 * kTriangles, 0);
    const std::string indices = std::to_string(maker.indices(corners));
    maker.add("\"nodes\":[" + repeated("{\"mesh\":0}", kNodes) +
              "],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + p + "},\"indices\":" + indices +
              "}]}]");
    check_sharing_refused(maker, "more than 100000000 triangles");
}

}  // namespace lumi::baker
