// SPDX-License-Identifier: MIT
// glTF files whose primitives share vertices, whose nodes share meshes, or whose materials are alike.
#include <catch2/catch.hpp>

#include "lumi/baker/scene.h"
#include "material/texture_slot.h"
#include "model/readers.h"
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

// A triangle with a colour of its own at each corner.
std::string coloured_triangle(GltfMaker& maker)
{
    const std::string p = std::to_string(maker.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    const std::string c = std::to_string(maker.vec3({0.8f, 0.4f, 0.4f, 0.4f, 0.8f, 0.4f, 0.4f, 0.4f, 0.8f}));
    return "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + p + ",\"COLOR_0\":" + c + "}}]}]";
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

TEST_CASE("glTF: a coloured mesh that many nodes place has one material and one picture")
{
    constexpr uint32_t kNodes = 100;
    GltfMaker maker;
    maker.add("\"nodes\":[" + repeated("{\"mesh\":0,\"scale\":[2,1,1]}", kNodes) + "]," + coloured_triangle(maker));
    const SceneParts parts = read_sharing(maker);
    REQUIRE(parts.mesh.triangle_count() == kNodes);
    CHECK(parts.materials.size() == 1);
    CHECK(parts.textures.size() == 1);
    for (const uint32_t triangle : {0u, kNodes - 1}) {
        const Material& material = parts.materials[parts.mesh.materials[triangle]];
        const Rgb seen = slot_colour(parts.mesh, parts.textures, material.maps.base, triangle, {1, 0});
        CHECK(seen.g == Approx(0.8).margin(0.01));
        CHECK(seen.r == Approx(0.4).margin(0.01));
    }
}

TEST_CASE("glTF: a coloured mesh shows its colours mirrored, and flat where a node leaves triangles out")
{
    GltfMaker maker;
    const std::string p = std::to_string(maker.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 5, 1, 0, 5, 0, 0, 6}));
    const std::string c = std::to_string(maker.vec3(
        {0.8f, 0.4f, 0.4f, 0.4f, 0.8f, 0.4f, 0.4f, 0.4f, 0.8f, 0.4f, 0.4f, 0.4f, 0.6f, 0.6f, 0.6f, 0.4f, 0.4f, 0.4f}));
    const std::string order = std::to_string(maker.indices({3, 4, 5, 0, 1, 2}));
    // The second triangle's corners are 0, 1, 2; in the flat node the first one, in the plane y = 0, has no area.
    maker.add(
        "\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"scale\":[-1,1,1]},{\"mesh\":0,\"scale\":[1,1,0]},"
        "{\"mesh\":0,\"translation\":[3,0,0]}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" +
        p + ",\"COLOR_0\":" + c + "},\"indices\":" + order + "}]}]");
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    const SceneParts parts = read_gltf(folder.write("m.glb", maker.glb()), warnings);
    REQUIRE(parts.mesh.triangle_count() == 7);
    const auto green_at = [&](uint32_t triangle, const Vec2& place) {
        const Material& material = parts.materials[parts.mesh.materials[triangle]];
        return slot_colour(parts.mesh, parts.textures, material.maps.base, triangle, place).g;
    };
    CHECK(green_at(1, {1, 0}) == Approx(0.8).margin(0.01));
    CHECK(green_at(3, {0, 1}) == Approx(0.8).margin(0.01));  // its second and third corner have changed places
    CHECK(green_at(4, {1, 0}) == Approx(0.8).margin(0.01));
    CHECK(green_at(5, {1, 0}) == Approx(0.6).margin(0.01));
    CHECK(green_at(6, {1, 0}) == Approx(0.8).margin(0.01));
}

TEST_CASE("glTF: nodes that place a mesh of very many points are read at once")
{
    constexpr size_t kPrimitives = 20000, kNodes = 100000;  // 2 * 10^9 pairs
    GltfMaker maker;
    const std::string p = std::to_string(maker.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    const std::string points = "{\"attributes\":{\"POSITION\":" + p + "},\"mode\":0}";
    maker.add("\"nodes\":[" + repeated("{\"mesh\":0}", kNodes) + "],\"meshes\":[{\"primitives\":[" +
              repeated(points, kPrimitives) + "]}]");
    check_sharing_refused(maker, "no triangle");
}

}  // namespace lumi::baker
