// SPDX-License-Identifier: MIT
// Hostile glTF files: a message that names the file and the mend, never a crash.
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

// Holds what is read of a hostile file that is none the less a model.
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

bool is_finite(const Rgb& c)
{
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

Material bounded_material(const std::string& members)
{
    return read_bounded(square(members)).parts.materials.at(0);
}

// A square whose base picture lies as the members of a KHR_texture_transform say.
GltfMaker square_with_transform(const std::string& transform)
{
    GltfMaker maker = square(
        "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"extensions\":{"
        "\"KHR_texture_transform\":{" +
        transform + "}}}}");
    const std::string view = std::to_string(maker.view(testing::rgb_png(1, {255, 0, 0})));
    maker.add("\"images\":[{\"bufferView\":" + view + ",\"mimeType\":\"image/png\"}],\"textures\":[{\"source\":0}]");
    return maker;
}

// The first triangle shows the red picture.
void check_red(const SceneParts& parts)
{
    const Vec2 middle = {0.25f, 0.25f};
    const Material& material = parts.materials[parts.mesh.materials[0]];
    const Rgb seen = slot_colour(parts.mesh, parts.textures, material.maps.base, 0, middle);
    CHECK(seen.r == Approx(1));
    CHECK(seen.g == 0);
}

}  // namespace

TEST_CASE("glTF: what is required and not drawn is refused by its name, with the way out")
{
    const auto requiring = [](const std::string& extension) {
        return glb_with(square(), "\"extensionsRequired\":[\"" + extension + "\"]");
    };
    check_gltf_refused(requiring("EXT_texture_avif"), "AVIF");
    check_gltf_refused(requiring("KHR_texture_basisu"), "KTX2");
    check_gltf_refused(requiring("ACME_wobble"), "ACME_wobble");
    GltfMaker basis = square("\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}");
    basis.add(
        "\"textures\":[{\"extensions\":{\"KHR_texture_basisu\":{\"source\":0}}}],\"images\":[{\"uri\":\"p.ktx2\"}]");
    check_gltf_refused(basis.glb(), "KTX2");
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

TEST_CASE("glTF: a GLB whose header says that it ends before its first chunk does is refused")
{
    // Found by fuzzing: texts of packed meshes are searched in the whole file, and such a file's chunk was cut out.
    using namespace std::string_literals;
    for (const char size : {'\0', '\x0C', '\x13'}) {
        const std::string lengths = size + "\0\0\0"s + "\xE4\x01\0\0"s;
        check_gltf_refused("glTF\2\0\0\0"s + lengths + "JSON{\"KHR_draco_mesh_compression\":1}", "beyond");
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

TEST_CASE("glTF: pictures that lie farther off than their pixels are told apart take the default, with a word")
{
    for (const char* transform : {"\"offset\":[1e300,0]", "\"offset\":[0,-1e30]", "\"scale\":[1e300,1e300]",
                                  "\"scale\":[1e-3,2e6]", "\"offset\":[1e300,-1e300],\"rotation\":1e300"}) {
        INFO(transform);
        const BoundedGltf far_off = read_bounded(square_with_transform(transform));
        check_red(far_off.parts);
        REQUIRE(far_off.warnings.size() == 1);
        CHECK_THAT(far_off.warnings[0], Catch::Contains("1 picture(s) are moved or scaled by more than a million"));
    }
    CHECK(read_bounded(square_with_transform("\"offset\":[1e6,0],\"scale\":[1e6,1]")).warnings.empty());
}

TEST_CASE("glTF: texture coordinates and colours at vertices stay finite in all that is made of them")
{
    constexpr float kMost = std::numeric_limits<float>::max();
    GltfMaker maker = square_with_transform("\"scale\":[1e6,1e6]");
    const std::string p = std::to_string(maker.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    const std::string uvs = std::to_string(maker.vec2({kMost, -kMost, -kMost, kMost, kMost, kMost}));
    const std::string colours = std::to_string(maker.vec3({kMost, 0, 0, -kMost, kMost, 1, kMost, kMost, kMost}));
    const std::string far_off =
        "{\"attributes\":{\"POSITION\":" + p + ",\"TEXCOORD_0\":" + uvs + ",\"COLOR_0\":" + colours;
    GltfMaker with_picture = maker;
    with_picture.add("\"meshes\":[{\"primitives\":[" + far_off + "},\"material\":0}]}]");
    const SceneParts mapped = read_bounded(with_picture).parts;
    for (const Material& material : mapped.materials) CHECK(is_finite(material.base));
    check_red(mapped);
    GltfMaker plain = maker;
    plain.add("\"meshes\":[{\"primitives\":[" + far_off + "}}]}]");
    const SceneParts coloured = read_bounded(plain).parts;
    const TextureSlot& slot = coloured.materials[coloured.mesh.materials[0]].maps.base;
    REQUIRE(slot.used());
    for (const Vec2 place : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0.25f, 0.5f}})
        CHECK(is_finite(slot_colour(coloured.mesh, coloured.textures, slot, 0, place)));
}

TEST_CASE("glTF: factors beyond binary32 give materials of finite numbers")
{
    const auto with = [](const std::string& extension, const std::string& more = "") {
        return bounded_material("\"pbrMetallicRoughness\":{\"metallicFactor\":0}" + more +
                                ",\"extensions\":{\"KHR_materials_" + extension + "}");
    };
    const Material dark = with("specular\":{\"specularFactor\":1e300,\"specularColorFactor\":[0,0,0]}");
    CHECK(dark.base.r == 1);
    CHECK_FALSE(dark.specular);
    CHECK(with("ior\":{\"ior\":1e300}").base.r == Approx(0.64));
    const Material lamp = with("emissive_strength\":{\"emissiveStrength\":1e300}", ",\"emissiveFactor\":[1,0.5,0]");
    CHECK(lamp.emission.r == kMaxRadiance);
    CHECK(lamp.emission.b == 0);
    const Material sheen = with("sheen\":{\"sheenColorFactor\":[1e300,0,0],\"sheenRoughnessFactor\":-1e300}");
    CHECK(sheen.sheen_colour.r == 1);
    CHECK(sheen.sheen_roughness == static_cast<float>(kMinSheenRoughness));
    const Material glass = with(
        "transmission\":{\"transmissionFactor\":1},\"KHR_materials_volume\":{"
        "\"attenuationDistance\":1e300,\"attenuationColor\":[0,1e300,1]}");
    CHECK(is_finite(glass.absorption));
    CHECK(std::isfinite(glass.transmittance_length));
    const Material smooth = bounded_material(
        "\"pbrMetallicRoughness\":{\"roughnessFactor\":0},\"extensions\":{\"KHR_materials_anisotropy\":{"
        "\"anisotropyStrength\":0,\"anisotropyRotation\":1e300}}");
    CHECK(smooth.anisotropy == 0);
    CHECK(std::isfinite(smooth.anisotropy_turns));
    CHECK(is_finite(bounded_material("\"pbrMetallicRoughness\":{\"baseColorFactor\":[1e300,-1e300,0,1e300]}").base));
}

TEST_CASE("glTF: lamps beyond what can be drawn are left out or bounded")
{
    const std::string lamp = "\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}";
    const auto fixtures = [](const GltfMaker& nodes) {
        GltfMaker maker = nodes;
        maker.add(
            "\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[{\"type\":\"point\",\"intensity\":1e300,"
            "\"color\":[1,0.5,0]}]}}");
        return read_bounded(maker).parts.fixtures;
    };
    const std::vector<Fixture> bright = fixtures(square("", lamp));
    REQUIRE(bright.size() == 1);
    CHECK(std::get<PointLight>(bright[0]).intensity.r == kMaxRadiance);
    CHECK(std::get<PointLight>(bright[0]).intensity.b == 0);
    CHECK(fixtures(square("", "\"children\":[1]", ",{\"translation\":[1e300,0,0]," + lamp + "}")).empty());
    check_gltf_refused(square("", "\"extensions\":{\"KHR_lights_punctual\":{\"light\":1e300}}").glb(),
                       "light 1000000000");
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
