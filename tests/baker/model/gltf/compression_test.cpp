// SPDX-License-Identifier: MIT
// glTF files whose meshes or pictures are compressed.
#include <webp/encode.h>

#include <catch2/catch.hpp>

#include "lumi/baker/scene.h"
#include "model/readers.h"
#include "support/packed_gltf.h"
#include "support/picture_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using testing::GltfMaker;
using testing::ScratchFolder;

SceneParts unpacked(const std::string& bytes)
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    SceneParts parts = read_gltf(folder.write("m.glb", bytes), warnings);
    CHECK(warnings.empty());
    return parts;
}

void check_square(const SceneParts& parts, double margin)
{
    REQUIRE(parts.mesh.triangle_count() == 2);
    CHECK(static_cast<double>(parts.mesh.area(0) + parts.mesh.area(1)) == Approx(1).margin(margin));
}

// Every truncation of the packed bytes gives a model or a message.
template <class Wrap>
void check_truncations(const std::string& packed, const Wrap& wrap)
{
    const ScratchFolder folder;
    for (size_t k = 0; k < packed.size(); ++k) {
        std::vector<std::string> warnings;
        try {
            read_gltf(folder.write("m.glb", wrap(packed.substr(0, k))), warnings);
        } catch (const SceneError& e) {
            CHECK_THAT(e.what(), Catch::Contains("; "));
        }
    }
}

std::string webp_picture()
{
    const uint8_t rgba[] = {255, 0, 0, 255, 0, 0, 255, 0};
    uint8_t* bytes = nullptr;
    const size_t size = WebPEncodeLosslessRGBA(rgba, 2, 1, 8, &bytes);
    const std::string result(reinterpret_cast<const char*>(bytes), size);
    WebPFree(bytes);
    return result;
}

// The first of the pictures is used.
std::string webp_glb(const std::string& picture, size_t pictures = 1)
{
    GltfMaker maker = testing::square("\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}");
    const std::string view = std::to_string(maker.view(picture));
    std::string images;
    for (size_t k = 0; k < pictures; ++k)
        images += (k == 0 ? "" : ",") + ("{\"bufferView\":" + view + ",\"mimeType\":\"image/webp\"}");
    maker.add("\"extensionsRequired\":[\"EXT_texture_webp\"],\"images\":[" + images +
              "],\"textures\":[{\"extensions\":{\"EXT_texture_webp\":{\"source\":0}}}]");
    return maker.glb();
}

// Heads of pictures of 8192 pixels a side, without the pixels.
std::string webp_head()
{
    const uint32_t less_one = 8191, sides = less_one | less_one << 14;
    std::string bits;
    for (int k = 0; k < 4; ++k) bits += static_cast<char>(sides >> 8 * k);
    return std::string("RIFF\x1E\0\0\0WEBPVP8L\x12\0\0\0\x2F", 21) + bits + std::string(20, '\0');
}

std::string png_head()
{
    const std::string side("\0\0\x20\0", 4);
    return std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16) + side + side + std::string(20, '\0');
}

std::string jpeg_head()
{
    std::string bytes = testing::jpeg(1, 1);
    bytes.replace(bytes.find("\xFF\xC0") + 5, 4, "\x20\0\x20\0", 4);  // height and width
    return bytes;
}

}  // namespace

TEST_CASE("glTF: meshes that Draco compressed are those of plain ones")
{
    check_square(unpacked(testing::draco_gltf(testing::draco_square()).glb()), 1e-3);
}

TEST_CASE("glTF: views that meshopt compressed are those of plain ones, also without bytes in their own buffer")
{
    check_square(unpacked(testing::meshopt_square()), 1e-6);
}

TEST_CASE("glTF: WebP pictures are read, with their alpha")
{
    const SceneParts parts = unpacked(webp_glb(webp_picture()));
    REQUIRE(parts.textures.size() == 1);
    CHECK(parts.textures[0].width == 2);
    CHECK(parts.textures[0].rgb[0] == 255);
}

TEST_CASE("glTF: Draco and WebP bytes that are cut off give a model or a message")
{
    check_truncations(
        testing::draco_square(), [](const std::string& b) { return testing::draco_gltf(b + " ").glb(); });
    check_truncations(webp_picture(), [](const std::string& b) { return webp_glb(b + " "); });
}

TEST_CASE("glTF: compressed meshes that claim more than their bytes can hold are refused")
{
    const ScratchFolder folder;
    const auto check_refused = [&](const std::string& bytes, const char* word) {
        std::vector<std::string> warnings;
        CHECK_THROWS_WITH(read_gltf(folder.write("m.glb", bytes), warnings), Catch::Contains(word));
    };
    check_refused(testing::meshopt_square(400'000'000), "more than its bytes can hold");
    // Sequential: 2^28 triangles of 2^28 points.
    const std::string many("\x80\x80\x80\x80\x01", 5), head("DRACO\x02\x02\x01\x00\x00\x00", 11);
    check_refused(testing::draco_gltf(head + many + many).glb(), "more than its bytes can hold");
    check_refused(testing::draco_gltf("DRACO").glb(), "Draco");
}

TEST_CASE("glTF: what compressed meshes of a file claim in all is refused before anything is unpacked")
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    const std::string packed(5'000'000, '\x01');  // 64 times as much passes once, and not twice
    GltfMaker maker;
    maker.view(packed);
    const std::string view =
        "{\"buffer\":0,\"byteLength\":4,\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,"
        "\"byteLength\":5000000,\"byteStride\":256,\"count\":1250000,\"mode\":\"ATTRIBUTES\"}}}";
    const std::string text =
        "{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"EXT_meshopt_compression\"],"
        "\"buffers\":[{\"byteLength\":5000000}],\"bufferViews\":[" +
        view + "," + view + "]}";
    const auto meshopt = folder.write("meshopt.glb", GltfMaker::glb_of(text, maker.bin()));
    CHECK_THROWS_WITH(read_gltf(meshopt, warnings), Catch::Contains("claim to unpack to more than 256 MB"));
    const std::string many("\x80\x80\x80\x80\x01", 5), head("DRACO\x02\x02\x01\x00\x00\x00", 11);
    const auto draco = folder.write("draco.glb", testing::draco_gltf(head + many + many + packed).glb());
    CHECK_THROWS_WITH(read_gltf(draco, warnings), Catch::Contains("claim to unpack to more than 256 MB"));
}

TEST_CASE("glTF: a view that meshopt compressed may lie in a buffer of few bytes")
{
    GltfMaker maker;
    maker.view(std::string(12, '\xA0'));
    const std::string text =
        "{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"EXT_meshopt_compression\"],"
        "\"buffers\":[{\"byteLength\":12}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":4,\"extensions\":{"
        "\"EXT_meshopt_compression\":{\"buffer\":0,\"byteLength\":12,\"byteStride\":4,\"count\":1,"
        "\"mode\":\"ATTRIBUTES\"}}}]}";
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    const auto file = folder.write("m.glb", GltfMaker::glb_of(text, maker.bin()));
    CHECK_THROWS_WITH(read_gltf(file, warnings), Catch::Contains("is damaged"));
}

TEST_CASE("glTF: pictures that are too large in all are refused before any is decoded")
{
    const ScratchFolder folder;
    for (const std::string& picture : {webp_head(), png_head(), jpeg_head()}) {
        std::vector<std::string> warnings;
        const auto three = folder.write("three.glb", webp_glb(picture, 3));
        CHECK_THROWS_WITH(read_gltf(three, warnings), Catch::Contains("pictures are too large in all"));
        CHECK(warnings.empty());
        CHECK_NOTHROW(read_gltf(folder.write("two.glb", webp_glb(picture, 2)), warnings));
        CHECK(warnings.size() == 1);  // it is damaged
    }
}

TEST_CASE("glTF: compressed bytes may be shared by two meshes, and not unpacked again and again")
{
    CHECK(unpacked(testing::draco_gltf(testing::draco_square(), 2).glb()).mesh.triangle_count() == 4);
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    const auto file = folder.write("m.glb", testing::draco_gltf(testing::draco_square(), 3).glb());
    CHECK_THROWS_WITH(read_gltf(file, warnings), Catch::Contains("share their bytes"));
}

}  // namespace lumi::baker
