// SPDX-License-Identifier: MIT
// Good glTF files: triangles, materials and lamps as the specification says.
#include "model/readers.h"

#include <png.h>

#include <catch2/catch.hpp>

#include "lumi/baker/scene.h"
#include "material/texture_slot.h"
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

struct LoadedGltf {
    SceneParts parts;
    std::string warnings;
};

LoadedGltf load_glb(const GltfMaker& maker)
{
    const ScratchFolder folder;
    LoadedGltf loaded;
    std::vector<std::string> lines;
    loaded.parts = read_gltf(folder.write("m.glb", maker.glb()), lines);
    for (const std::string& line : lines) loaded.warnings += line + "\n";
    return loaded;
}

Material gltf_material(const std::string& gltf)
{
    const LoadedGltf loaded = load_glb(square(gltf));
    CHECK(loaded.warnings.empty());
    REQUIRE(loaded.parts.materials.size() == 1);
    return loaded.parts.materials[0];
}

// A square whose material has the picture of a PNG as texture 0.
LoadedGltf load_with_picture(const std::string& png, const std::string& material)
{
    GltfMaker maker = square(material);
    const std::string view = std::to_string(maker.view(png));
    maker.add("\"images\":[{\"bufferView\":" + view + ",\"mimeType\":\"image/png\"}],\"textures\":[{\"source\":0}]");
    return load_glb(maker);
}

// Returns what a slot of the first material shows where the square's plane has the coordinates.
Rgb shown_on_square(const SceneParts& parts, TextureSlot TextureSlots::*slot, float x, float y)
{
    const Vec2 barycentric = x > y ? Vec2{x - y, y} : Vec2{x, y - x};
    return slot_colour(parts.mesh, parts.textures, parts.materials[0].maps.*slot, x > y ? 0 : 1, barycentric);
}

Vec3 first_corner(const LoadedGltf& loaded)
{
    return loaded.parts.mesh.position(0, 0);
}

void check_gltf(const Vec3& a, const Vec3& b)
{
    INFO(a.x << " " << a.y << " " << a.z << " instead of " << b.x << " " << b.y << " " << b.z);
    CHECK(length(a - b) < 1e-5f);
}

void check_gltf(const Rgb& a, const Rgb& b, float tolerance)
{
    INFO(a.r << " " << a.g << " " << a.b << " instead of " << b.r << " " << b.g << " " << b.b);
    CHECK(std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) <= tolerance);
}

// Red and green beside each other, blue and white below.
std::string four_colours()
{
    return testing::png({PNG_COLOR_TYPE_RGB}, 2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255});
}

}  // namespace

TEST_CASE("glTF: a square of two triangles, flat without normals, grey without a material")
{
    const LoadedGltf l = load_glb(square());
    CHECK(l.warnings.empty());
    REQUIRE(l.parts.mesh.triangle_count() == 2);
    CHECK(l.parts.mesh.area(0) + l.parts.mesh.area(1) == Approx(1));
    CHECK(l.parts.mesh.shading[0][0] == kNoIndex);
    CHECK(l.parts.materials.size() == 1);
    CHECK_FALSE(l.parts.materials[0].specular);
}

TEST_CASE("glTF: nodes scale, then turn, then move, one inside the other, a mirror turns the winding")
{
    // A quarter about z: x becomes y.
    const char* turned = "\"rotation\":[0,0,0.70710678,0.70710678],\"scale\":[2,3,1],\"translation\":[5,0,0]";
    const LoadedGltf l = load_glb(square("", turned));
    check_gltf(first_corner(l), {5, 0, 0});
    check_gltf(l.parts.mesh.position(0, 1), {5, 2, 0});
    check_gltf(l.parts.mesh.position(0, 2), {2, 2, 0});
    const LoadedGltf mirrored = load_glb(square("", "\"scale\":[-1,1,1]"));
    CHECK(mirrored.parts.mesh.area_vector(0).z > 0);
    const LoadedGltf by_matrix = load_glb(square("", "\"matrix\":[0,2,0,0,-3,0,0,0,0,0,1,0,5,0,0,1]"));
    for (size_t k = 0; k < 3; ++k) check_gltf(by_matrix.parts.mesh.position(0, k), l.parts.mesh.position(0, k));

    GltfMaker family;
    const std::string p = std::to_string(family.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    family.add("\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + p + "}}]}]");
    family.add(
        "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"translation\":[1,0,0],\"children\":[1,2]},"
        "{\"mesh\":0,\"translation\":[0,1,0]},{\"mesh\":0,\"scale\":[2,2,2]}]");
    const LoadedGltf both = load_glb(family);
    REQUIRE(both.parts.mesh.triangle_count() == 2);
    check_gltf(both.parts.mesh.position(0, 0), {1, 1, 0});
    check_gltf(both.parts.mesh.position(1, 1), {3, 0, 0});
}

TEST_CASE("glTF: strips and fans become triangles of one winding, points are counted")
{
    GltfMaker maker;
    const std::string p = std::to_string(maker.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}));
    const std::string fan = std::to_string(maker.indices({0, 1, 3, 2}));
    const std::string primitive = "{\"attributes\":{\"POSITION\":" + p + "},\"mode\":";
    maker.add("\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[" + primitive + "5}," + primitive +
              "6,\"indices\":" + fan + "}," + primitive + "0}," + primitive + "0}]}]");
    const LoadedGltf l = load_glb(maker);
    REQUIRE(l.parts.mesh.triangle_count() == 4);
    for (size_t t = 0; t < 4; ++t) CHECK(l.parts.mesh.area_vector(t).z == Approx(1));
    CHECK_THAT(l.warnings, Catch::Contains("2 primitive(s) are points or lines"));
}

TEST_CASE("glTF: quantised, normalised, interleaved and sparse numbers are those of plain ones")
{
    const auto corners_with = [](GltfMaker maker, size_t positions) {
        maker.add("\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" +
                  std::to_string(positions) + "}}]}]");
        return load_glb(maker).parts.mesh;
    };
    const auto check = [](const Mesh& mesh) {
        check_gltf(mesh.position(0, 0), {0, 0, 0});
        check_gltf(mesh.position(0, 1), {1, 0, 0});
        check_gltf(mesh.position(0, 2), {0, -1, 0});
    };
    GltfMaker shorts;
    const size_t a =
        shorts.numbers<int16_t>({0, 0, 0, 32767, 0, 0, 0, -32767, 0}, 5122, "VEC3", 3, ",\"normalized\":true");
    check(corners_with(shorts, a));
    GltfMaker bytes;
    const size_t b = bytes.numbers<int8_t>({0, 0, 0, 1, 0, 0, 0, -1, 0}, 5120, "VEC3", 3);
    check(corners_with(bytes, b));
    GltfMaker gaps;
    std::string rows(16 * 3, '\x7F');
    const float numbers[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}};
    for (size_t k = 0; k < 3; ++k) std::memcpy(&rows[16 * k + 4], numbers[k], 12);
    const size_t view = gaps.view(rows, ",\"byteStride\":16");
    check(corners_with(gaps, gaps.accessor("\"bufferView\":" + std::to_string(view) +
                                           ",\"byteOffset\":4,\"componentType\":5126,\"type\":\"VEC3\",\"count\":3")));
    GltfMaker sparse;
    const size_t places = sparse.view(std::string("\1\2", 2));
    std::string values(24, '\0');
    std::memcpy(values.data(), numbers[1], 24);
    const size_t replaced = sparse.view(values);
    check(corners_with(sparse,
                       sparse.accessor("\"componentType\":5126,\"type\":\"VEC3\",\"count\":3,\"sparse\":{\"count\":"
                                       "2,\"indices\":{\"bufferView\":" +
                                       std::to_string(places) + ",\"componentType\":5121},\"values\":{\"bufferView\":" +
                                       std::to_string(replaced) + "}}")));
}

TEST_CASE("glTF: metallic and roughness are those of a scene file, the body shows what the skin lets in")
{
    const Material plastic = gltf_material(
        "\"name\":\"p\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0.25,1,1],\"metallicFactor\":0,"
        "\"roughnessFactor\":0.5}");
    CHECK(plastic.name == "p");
    CHECK(plastic.specular);
    CHECK(plastic.index == Approx(1.5));
    CHECK(plastic.alpha == Approx(0.25));
    CHECK(plastic.rough_body);
    check_gltf(plastic.base, Rgb{0.5f, 0.25f, 1} * 0.96f, 1e-6f);
    const Material half = gltf_material(
        "\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0.25,1,1],\"metallicFactor\":0.5,"
        "\"roughnessFactor\":0.75}");
    CHECK(half.metalness == 0.5f);
    CHECK(half.alpha == Approx(0.5625));
    check_gltf(half.base, Rgb{0.5f, 0.25f, 1} * 0.98f, 1e-6f);
    const Material metal = gltf_material("\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0.25,1,1]}");
    CHECK(metal.metalness == 1);
    CHECK(metal.alpha == 1);
    check_gltf(metal.base, {0.5f, 0.25f, 1}, 1e-6f);
}

TEST_CASE("glTF: extensions of materials: index, specular, coat, sheen, emission, unlit, glass")
{
    const auto with = [](const std::string& extension, const std::string& more = "") {
        return gltf_material("\"pbrMetallicRoughness\":{\"metallicFactor\":0}" + more +
                             ",\"extensions\":{\"KHR_materials_" + extension + "}");
    };
    CHECK(with("ior\":{\"ior\":1.8}").index == Approx(1.8));
    CHECK(with("specular\":{\"specularFactor\":0.5}").index == Approx((1 + std::sqrt(0.02)) / (1 - std::sqrt(0.02))));
    CHECK_FALSE(with("specular\":{\"specularFactor\":0}").specular);
    const Material coated = with("clearcoat\":{\"clearcoatFactor\":0.5,\"clearcoatRoughnessFactor\":0.3}");
    CHECK(coated.coat == 0.5f);
    CHECK(coated.coat_alpha == Approx(0.09));
    CHECK(with("sheen\":{\"sheenColorFactor\":[1,0,0],\"sheenRoughnessFactor\":0.4}").sheen_roughness == Approx(0.4));
    // Widths of 0.25 across and 0.25 + 0.75 · 0.5² along.
    const Material brushed = gltf_material(
        "\"pbrMetallicRoughness\":{\"roughnessFactor\":0.5},\"extensions\":{\"KHR_materials_anisotropy\":{"
        "\"anisotropyStrength\":0.5,\"anisotropyRotation\":1.5707963}}");
    const float aspect = std::sqrt(1 - 0.9f * brushed.anisotropy);
    CHECK(brushed.alpha / aspect == Approx(0.4375));
    CHECK(brushed.alpha * aspect == Approx(0.25));
    CHECK(brushed.anisotropy_turns == Approx(0.25));
    const Material lamp = with("emissive_strength\":{\"emissiveStrength\":5}", ",\"emissiveFactor\":[1,0.5,0]");
    check_gltf(lamp.emission, {5, 2.5f, 0}, 0);
    const Material unlit = with("unlit\":{}");
    check_gltf(unlit.emission, grey(1), 0);
    CHECK(is_black(unlit.base));
    const Material glass = with(
        "transmission\":{\"transmissionFactor\":1},\"KHR_materials_volume\":{"
        "\"attenuationDistance\":2,\"attenuationColor\":[0.5,1,1]}");
    CHECK(glass.glass);
    CHECK(glass.transmittance_length == 2);
    CHECK(glass.absorbed(2).r == Approx(0.5));
    const Material pane = with("transmission\":{\"transmissionFactor\":0.25}");
    CHECK(pane.thin);
    CHECK(pane.transmission == 0.25f);
    const Material old = with(
        "pbrSpecularGlossiness\":{\"diffuseFactor\":[0.5,0.5,0.5,1],\"specularFactor\":[0.04,0.04,0.04],"
        "\"glossinessFactor\":0.5}");
    CHECK(old.base.r == Approx(0.48));
    CHECK(old.alpha == Approx(0.25));
}

TEST_CASE("glTF: glass keeps the distance of its volume beside glass of the same name that has none")
{
    GltfMaker maker;
    const std::string p = std::to_string(maker.vec3({0, 0, 0, 2, 0, 0, 0, 2, 2}));
    const std::string primitive = "{\"attributes\":{\"POSITION\":" + p + "},\"material\":";
    maker.add("\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[" + primitive + "0}," + primitive + "1}]}]");
    const std::string clear = "\"KHR_materials_transmission\":{\"transmissionFactor\":1}";
    const std::string smooth = "{\"pbrMetallicRoughness\":{\"metallicFactor\":0},\"extensions\":{" + clear;
    maker.add("\"materials\":[" + smooth +
              ",\"KHR_materials_volume\":{\"attenuationDistance\":0.1,\"attenuationColor\":[0.5,1,1]}}}," + smooth +
              "}}]");
    const SceneParts parts = load_glb(maker).parts;
    REQUIRE(parts.materials.size() == 2);
    CHECK(parts.materials[0].transmittance_length == 0.1f);
    CHECK(parts.materials[0].absorbed(0.1f).r == Approx(0.5));
    CHECK(parts.materials[1].thin);
}

// Glass whose picture has so much metalness, and a picture of transmission.
SceneParts glass_with_pictures(uint8_t metal, uint8_t transmission)
{
    GltfMaker maker = square(
        "\"pbrMetallicRoughness\":{\"metallicRoughnessTexture\":{\"index\":0}},\"extensions\":{"
        "\"KHR_materials_transmission\":{\"transmissionFactor\":0.5,\"transmissionTexture\":{\"index\":1}},"
        "\"KHR_materials_volume\":{\"thicknessFactor\":1}}");
    std::string images;
    for (const uint8_t byte : {metal, transmission}) {
        const bool is_metal = images.empty();
        const std::string png =
            testing::rgb_png(1, {is_metal ? uint8_t{0} : byte, uint8_t{0}, is_metal ? byte : uint8_t{0}});
        images += (is_metal ? "" : ",") + ("{\"bufferView\":" + std::to_string(maker.view(png))) +
                  ",\"mimeType\":\"image/png\"}";
    }
    maker.add("\"images\":[" + images + "],\"textures\":[{\"source\":0},{\"source\":1}]");
    return load_glb(maker).parts;
}

TEST_CASE("glTF: pictures of glass count, of metalness, roughness and transmission")
{
    const SceneParts clear = glass_with_pictures(0, 51);
    const Material& glass = clear.materials.at(0);
    CHECK(glass.glass);
    CHECK(glass.metalness == 0);
    CHECK(glass.transmission * shown_on_square(clear, &TextureSlots::transmission, 0.5f, 0.25f).r == Approx(0.1));
    REQUIRE(glass.frosts.size() > 1);
    CHECK_FALSE(glass.frosts[0]);
    CHECK(glass.frosts.back());
    CHECK(glass_with_pictures(51, 255).materials.at(0).is_mixed_glass());
    CHECK_FALSE(glass_with_pictures(0, 0).materials.at(0).glass);
}

TEST_CASE("glTF: specular and glossiness become metal and roughness where the specular colour is a metal's")
{
    const auto old = [](const std::string& members) {
        return gltf_material("\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{" + members + "}}");
    };
    const Material gold = old("\"diffuseFactor\":[0,0,0,1],\"specularFactor\":[1,0.8,0.3],\"glossinessFactor\":0.5");
    CHECK(gold.metalness == Approx(1).margin(0.02));
    check_gltf(gold.base, {1, 0.8f, 0.3f}, 0.02f);
    const std::string png = testing::png({PNG_COLOR_TYPE_RGB_ALPHA}, 2, 1, {255, 231, 149, 255, 10, 10, 10, 51});
    const LoadedGltf both =
        load_with_picture(png,
                          "\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{\"diffuseFactor\":[0.5,0,0,1],"
                          "\"specularGlossinessTexture\":{\"index\":0}}}");
    CHECK(both.warnings.empty());
    CHECK(shown_on_square(both.parts, &TextureSlots::metalness, 0.2f, 0.1f).g > 0.7f);
    CHECK(shown_on_square(both.parts, &TextureSlots::metalness, 0.75f, 0.25f).g < 0.05f);
    CHECK(shown_on_square(both.parts, &TextureSlots::roughness, 0.25f, 0.1f).g == Approx(0).margin(0.01));
    CHECK(shown_on_square(both.parts, &TextureSlots::roughness, 0.75f, 0.25f).g == Approx(0.8));
}

TEST_CASE("glTF: pictures lie upright, roughness is green, metalness blue")
{
    const LoadedGltf base =
        load_with_picture(four_colours(), "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}");
    CHECK(base.warnings.empty());
    check_gltf(shown_on_square(base.parts, &TextureSlots::base, 0.25f, 0.75f), {1, 0, 0}, 1e-3f);
    check_gltf(shown_on_square(base.parts, &TextureSlots::base, 0.75f, 0.25f), {1, 1, 1}, 1e-3f);
    const LoadedGltf both = load_with_picture(testing::rgb_png(1, {0, 128, 64}),
                                              "\"pbrMetallicRoughness\":{\"metallicRoughnessTexture\":{\"index\":0}}");
    CHECK(shown_on_square(both.parts, &TextureSlots::roughness, 0.5f, 0.2f).g == Approx(128 / 255.0));
    CHECK(shown_on_square(both.parts, &TextureSlots::metalness, 0.5f, 0.2f).g == Approx(64 / 255.0));
}

TEST_CASE("glTF: cameras are views by the name of their node, with the place of all nodes above, without their scale")
{
    GltfMaker maker = square("", "\"translation\":[0,0,-1],\"children\":[1,2,3]",
                             ",{\"name\":\"Front\",\"camera\":0,\"translation\":[2,0,5],\"scale\":[3,3,3]},"
                             "{\"camera\":0,\"rotation\":[0,0.70710678,0,0.70710678]},{\"camera\":1}");
    maker.add(
        "\"cameras\":[{\"name\":\"lens\",\"type\":\"perspective\",\"perspective\":{\"yfov\":0.5,\"znear\":1}},"
        "{\"type\":\"orthographic\",\"orthographic\":{\"xmag\":1,\"ymag\":1,\"zfar\":9,\"znear\":1}}]");
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    const Scene scene = load_scene(folder.write("m.glb", maker.glb()), {}, warnings);
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Catch::Contains("1 camera(s) have no perspective"));
    REQUIRE(scene.views().size() == 2);
    const auto is_pose = [&](const NamedView& view, const std::array<double, 16>& pose) {
        for (size_t k = 0; k < pose.size(); ++k) {
            INFO(k);
            CHECK(view.pose[k] == Approx(pose[k]).margin(1e-6));
        }
    };
    // The square's middle is (0.5, 0.5, -1); the sphere's x, y, z are the scene's z, x, y.
    const double r = static_cast<double>(scene.radius());
    CHECK(scene.views()[0].name == "Front");
    CHECK(scene.views()[0].fov_y_degrees == Approx(28.6479));
    is_pose(scene.views()[0], {0, 0, 1, 5 / r, 1, 0, 0, 1.5 / r, 0, 1, 0, -0.5 / r, 0, 0, 0, 1});
    // A quarter to the left: it looks along -x.
    CHECK(scene.views()[1].name == "lens");
    is_pose(scene.views()[1], {-1, 0, 0, 0, 0, 0, 1, -0.5 / r, 0, 1, 0, -0.5 / r, 0, 0, 0, 1});
}

TEST_CASE("glTF: a node's name stands for all triangles below it")
{
    GltfMaker maker = square("", "\"name\":\"all\",\"children\":[1,2]",
                             ",{\"name\":\"left\",\"children\":[3]},{\"name\":\"right\",\"mesh\":0},"
                             "{\"name\":\"below\",\"mesh\":0}");
    const LoadedGltf l = load_glb(maker);
    std::string text;
    for (const NamedPart& part : l.parts.named)
        text += part.name + " " + std::to_string(part.first) + "-" + std::to_string(part.end) + "; ";
    CHECK(text == "all 0-6; left 2-4; below 2-4; right 4-6; ");
}

TEST_CASE("glTF: texture transforms scale, turn and move")
{
    const auto at = [](const std::string& transform, float x, float y) {
        const LoadedGltf l =
            load_with_picture(four_colours(),
                              "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"extensions\":{"
                              "\"KHR_texture_transform\":{" +
                                  transform + "}}}}");
        return shown_on_square(l.parts, &TextureSlots::base, x, y);
    };
    // Twice as small: the whole picture in the lower left quarter.
    check_gltf(at("\"scale\":[2,2]", 0.125f, 0.375f), {1, 0, 0}, 1e-3f);
    // u moves by half: what was right of the middle.
    check_gltf(at("\"offset\":[0.5,0]", 0.25f, 0.75f), {0, 1, 0}, 1e-3f);
    check_gltf(at("\"offset\":[0,0.5]", 0.25f, 0.75f), {0, 0, 1}, 1e-3f);
    // A quarter: (u, v) becomes (v, -u), so that the place at (0.25, 0.25) reads (0.25, -0.25), the lower left pixel.
    check_gltf(at("\"rotation\":1.5707963", 0.25f, 0.75f), {0, 0, 1}, 1e-3f);
}

TEST_CASE("glTF: pictures of one material may be turned and moved each by itself")
{
    const LoadedGltf l = load_with_picture(
        four_colours(),
        "\"emissiveFactor\":[1,1,1],\"emissiveTexture\":{\"index\":0,\"extensions\":{\"KHR_texture_transform\":{"
        "\"rotation\":1.5707963,\"scale\":[2,1],\"offset\":[0.5,0]}}},\"pbrMetallicRoughness\":{"
        "\"baseColorTexture\":{\"index\":0}}");
    CHECK(l.warnings.empty());
    check_gltf(shown_on_square(l.parts, &TextureSlots::base, 0.25f, 0.75f), {1, 0, 0}, 1e-3f);
    // glTF's (u, v) = (0.125, 0.25) becomes (0.25, 0.25), then (0.25, -0.25) by the turn, then (0.75, -0.25).
    check_gltf(shown_on_square(l.parts, &TextureSlots::emission, 0.125f, 0.75f), {1, 1, 1}, 1e-3f);
}

TEST_CASE("glTF: samplers repeat, hold the border, or mirror beyond the picture, in each direction by itself")
{
    const auto at = [](const std::string& modes, float x, float y) {
        GltfMaker maker = square(
            "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"extensions\":{"
            "\"KHR_texture_transform\":{\"scale\":[2,2]}}}}");
        const std::string view = std::to_string(maker.view(four_colours()));
        maker.add("\"images\":[{\"bufferView\":" + view +
                  ",\"mimeType\":\"image/png\"}],\"textures\":[{\"source\":0,\"sampler\":0}],\"samplers\":[{" + modes +
                  "}]");
        const LoadedGltf l = load_glb(maker);
        CHECK(l.warnings.empty());
        return shown_on_square(l.parts, &TextureSlots::base, x, y);
    };
    // x from 0.5 on lies beyond the picture; at 0.625 is its first quarter again, which the mirror shows as the last.
    check_gltf(at("\"wrapS\":10497", 0.625f, 0.875f), {1, 0, 0}, 1e-3f);
    check_gltf(at("\"wrapS\":33648", 0.625f, 0.875f), {0, 1, 0}, 1e-3f);
    check_gltf(at("\"wrapS\":33648", 0.875f, 0.875f), {1, 0, 0}, 1e-3f);
    check_gltf(at("\"wrapS\":33071", 0.875f, 0.875f), {0, 1, 0}, 1e-3f);
    // v of glTF runs downwards, so that y below 0.5 lies beyond the lower border.
    check_gltf(at("\"wrapT\":33648", 0.125f, 0.375f), {0, 0, 1}, 1e-3f);
    check_gltf(at("\"wrapT\":33071", 0.125f, 0.125f), {0, 0, 1}, 1e-3f);
}

TEST_CASE("glTF: pictures take the set of texture coordinates that they name, up to two a material")
{
    GltfMaker maker;
    const std::string positions = std::to_string(maker.vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
    const std::string first = std::to_string(maker.vec2({0, 1, 1, 1, 1, 0, 0, 0}));
    const std::string second = std::to_string(maker.vec2({0.75f, 0.25f, 0.75f, 0.25f, 0.75f, 0.25f, 0.75f, 0.25f}));
    const std::string indices = std::to_string(maker.indices({0, 1, 2, 0, 2, 3}));
    maker.add("\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"mesh\":1},{\"mesh\":0}]");
    maker.add("\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + positions + ",\"TEXCOORD_0\":" + first +
              ",\"TEXCOORD_3\":" + second + "},\"indices\":" + indices +
              ",\"material\":0}]},{\"primitives\":[{\"attributes\":{\"POSITION\":" + positions +
              ",\"TEXCOORD_0\":" + first + "},\"indices\":" + indices + ",\"material\":1}]}]");
    maker.add(
        "\"materials\":[{\"emissiveFactor\":[1,1,1],\"emissiveTexture\":{\"index\":0,\"texCoord\":3},"
        "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}},\"normalTexture\":{\"index\":0,"
        "\"texCoord\":2}},{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}]");
    const std::string view = std::to_string(maker.view(four_colours()));
    maker.add("\"images\":[{\"bufferView\":" + view + ",\"mimeType\":\"image/png\"}],\"textures\":[{\"source\":0}]");
    const LoadedGltf l = load_glb(maker);
    CHECK_THAT(l.warnings, Catch::Contains("1 picture(s) take a third set"));
    const auto shown = [&](TextureSlot TextureSlots::*slot, uint32_t triangle) {
        const TextureSlots& maps = l.parts.materials[l.parts.mesh.materials[triangle]].maps;
        return slot_colour(l.parts.mesh, l.parts.textures, maps.*slot, triangle, {0.5f, 0.25f});
    };
    // The second node's triangles; the first node's mesh, which lies before it, has no second set.
    check_gltf(shown(&TextureSlots::emission, 2), {0, 1, 0}, 1e-3f);
    check_gltf(shown(&TextureSlots::emission, 3), {0, 1, 0}, 1e-3f);
    check_gltf(shown(&TextureSlots::base, 2), {1, 1, 1}, 1e-3f);
    check_gltf(shown(&TextureSlots::base, 0), {1, 1, 1}, 1e-3f);
}

TEST_CASE("glTF: a coat's pictures count by their means, of red and of green, with a word")
{
    const LoadedGltf l = load_with_picture(
        testing::rgb_png(1, {51, 102, 255}),
        "\"extensions\":{\"KHR_materials_clearcoat\":{\"clearcoatFactor\":0.5,\"clearcoatRoughnessFactor\":0.5,"
        "\"clearcoatTexture\":{\"index\":0},\"clearcoatRoughnessTexture\":{\"index\":0}}}");
    CHECK(l.parts.materials[0].coat == Approx(0.1));
    CHECK(l.parts.materials[0].coat_alpha == Approx(0.04));
    CHECK_THAT(l.warnings, Catch::Contains("1 clear coat(s)"));
}

TEST_CASE("glTF: alpha cuts at the cutoff, blends, or does nothing")
{
    const std::string png = testing::png({PNG_COLOR_TYPE_RGB_ALPHA}, 2, 1, {9, 9, 9, 250, 9, 9, 9, 80});
    const auto opacity = [&](const std::string& mode, float x) {
        const LoadedGltf l =
            load_with_picture(png, "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}" + mode);
        return l.parts.materials[0].opacity * shown_on_square(l.parts, &TextureSlots::opacity, x, 0.25f).g;
    };
    CHECK(opacity("", 0.75f) == 1);
    CHECK(opacity(",\"alphaMode\":\"BLEND\"", 0.75f) == Approx(80 / 255.0));
    CHECK(gltf_material("\"alphaMode\":\"BLEND\"").blends);
    CHECK_FALSE(gltf_material("\"alphaMode\":\"MASK\"").blends);
    CHECK(opacity(",\"alphaMode\":\"MASK\"", 0.25f) == 1);
    CHECK(opacity(",\"alphaMode\":\"MASK\"", 0.75f) == 0);
    CHECK(opacity(",\"alphaMode\":\"MASK\",\"alphaCutoff\":0.2", 0.75f) == 1);
    CHECK(
        gltf_material("\"alphaMode\":\"BLEND\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,1,1,0.25]}").opacity ==
        0.25f);
}

TEST_CASE("glTF: normals lean as far as their scale says")
{
    const LoadedGltf l =
        load_with_picture(testing::rgb_png(1, {218, 128, 218}), "\"normalTexture\":{\"index\":0,\"scale\":0.5}");
    const Rgb n = shown_on_square(l.parts, &TextureSlots::normal, 0.5f, 0.25f);
    const float x = 2 * n.r - 1, z = 2 * n.b - 1;
    CHECK(x / z == Approx(0.5).margin(0.02));
}

TEST_CASE("glTF: colours at vertices show as a rasteriser interpolates them")
{
    // Corner colours 4/5 apart at most lie on a plane of colours; pure ones leave it by less than 0.09.
    for (const uint8_t dark : {uint8_t{100}, uint8_t{0}}) {
        GltfMaker maker;
        const std::string p = std::to_string(maker.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0}));
        const std::string c =
            std::to_string(maker.numbers<uint8_t>({200, dark, dark, 255, dark, 200, dark, 255, dark, dark, 200, 255},
                                                  5121, "VEC4", 3, ",\"normalized\":true"));
        maker.add("\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":" + p +
                  ",\"COLOR_0\":" + c + "}}]}]");
        const LoadedGltf l = load_glb(maker);
        CHECK(l.warnings.empty());
        const Material& material = l.parts.materials[l.parts.mesh.materials[0]];
        const float low = static_cast<float>(dark) / 255, range = 200 / 255.0f - low;
        for (const Vec2 b : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{0.25f, 0.5f}, Vec2{0.5f, 0.5f}}) {
            const Rgb seen = slot_colour(l.parts.mesh, l.parts.textures, material.maps.base, 0, b);
            check_gltf(seen, grey(low) + Rgb{1 - b.x - b.y, b.x, b.y} * range, dark == 0 ? 0.09f : 0.01f);
        }
    }
}

TEST_CASE("glTF: lamps of 683 candela or lux are intensities and irradiances of 1, along the node's -z")
{
    const auto lamp = [](const std::string& place, int light) {
        return ",{" + place + "\"extensions\":{\"KHR_lights_punctual\":{\"light\":" + std::to_string(light) + "}}}";
    };
    GltfMaker maker = square(
        "", "\"children\":[1,2,3]",
        lamp("\"translation\":[1,2,3],", 0) + lamp("\"rotation\":[0.70710678,0,0,0.70710678],", 1) + lamp("", 2));
    maker.add(
        "\"extensionsRequired\":[\"KHR_lights_punctual\"],\"extensions\":{\"KHR_lights_punctual\":{\"lights\":["
        "{\"type\":\"point\",\"intensity\":683,\"color\":[1,0.5,0]},"
        "{\"type\":\"directional\",\"intensity\":1366},"
        "{\"type\":\"spot\",\"intensity\":683,\"spot\":{\"innerConeAngle\":0.1,\"outerConeAngle\":0.5}}]}}");
    const SceneParts parts = load_glb(maker).parts;
    REQUIRE(parts.fixtures.size() == 3);
    const auto& point = std::get<PointLight>(parts.fixtures[0]);
    check_gltf(point.position, {1, 2, 3});
    check_gltf(point.intensity, {1, 0.5f, 0}, 1e-6f);
    const auto& sun = std::get<DirectionalLight>(parts.fixtures[1]);
    check_gltf(sun.towards, {0, -1, 0});
    CHECK(sun.irradiance.r == Approx(2));
    const auto& spot = std::get<SpotLight>(parts.fixtures[2]);
    check_gltf(spot.axis, {0, 0, -1});
    CHECK(spot.cos_outer == Approx(std::cos(0.5)));
    CHECK(spot.cos_inner == Approx(std::cos(0.1)));
}

TEST_CASE("glTF: buffers and pictures lie beside the file, in it as data, or under their last name")
{
    const GltfMaker maker = square();
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    folder.write("two words.bin", maker.bin());
    CHECK(read_gltf(folder.write("a.gltf", maker.json("two%20words.bin")), warnings).mesh.triangle_count() == 2);
    folder.write("b.bin", maker.bin());
    CHECK(read_gltf(folder.write("b.gltf", maker.json("C:/models/b.bin")), warnings).mesh.triangle_count() == 2);
    CHECK(warnings.empty());
    CHECK_THROWS_WITH(read_gltf(folder.write("c.gltf", maker.json("c.bin")), warnings),
                      Catch::Contains("c.gltf: ") && Catch::Contains("; put c.bin beside it"));
    GltfMaker pictures = square("\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}");
    pictures.add("\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"p.png\"}]");
    CHECK_FALSE(read_gltf(folder.write("d.glb", pictures.glb()), warnings).materials[0].maps.base.used());
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Catch::Contains("'p.png'") && Catch::Contains("missing"));
    folder.write("p.png", four_colours());
    CHECK(read_gltf(folder.at("d.glb"), warnings).materials[0].maps.base.used());
    CHECK(warnings.size() == 1);
}

}  // namespace lumi::baker
