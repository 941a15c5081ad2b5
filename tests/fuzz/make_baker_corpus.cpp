// SPDX-License-Identifier: MIT
// lumi_make_baker_corpus FOLDER: seeds of the targets that read what bakes read, in folders of the targets' names.
#include <ImfRgbaFile.h>
#include <png.h>
#include <webp/encode.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "support/bake_scenes.h"
#include "support/facet_bytes.h"
#include "support/gltf_bytes.h"
#include "support/nifti_bytes.h"
#include "support/packed_gltf.h"
#include "support/picture_bytes.h"
#include "surface/surface_file_store.h"

namespace
{

namespace fs = std::filesystem;
using namespace lumi::baker;

class Seeds
{
public:
    explicit Seeds(fs::path folder) : folder_(std::move(folder)) { fs::create_directories(folder_); }
    void add(const std::string& bytes) { std::ofstream(folder_ / std::to_string(count_++), std::ios::binary) << bytes; }

private:
    fs::path folder_;
    int count_ = 0;
};

std::string exr(Imf::Compression compression)
{
    const testing::ScratchFolder folder;
    std::vector<Imf::Rgba> pixels;
    for (int k = 0; k < 12 * 20; ++k) pixels.emplace_back(0.01f * static_cast<float>(k), 0.2f, 0.5f, 1.0f);
    {
        Imf::RgbaOutputFile out(folder.at("e").c_str(), 12, 20, Imf::WRITE_RGB, 1, {0, 0}, 1, Imf::INCREASING_Y,
                                compression);
        out.setFrameBuffer(pixels.data(), 1, 12);
        out.writePixels(20);
    }
    return testing::read_bytes(folder.at("e"));
}

std::string webp(bool lossless)
{
    const std::vector<uint8_t> rgba(size_t{4} * 12 * 8, 77);
    uint8_t* bytes = nullptr;
    const size_t size = lossless ? WebPEncodeLosslessRGBA(rgba.data(), 12, 8, 48, &bytes)
                                 : WebPEncodeRGBA(rgba.data(), 12, 8, 48, 60, &bytes);
    const std::string result(reinterpret_cast<const char*>(bytes), size);
    WebPFree(bytes);
    return result;
}

void write_pictures(Seeds seeds)
{
    for (const bool lossless : {false, true}) seeds.add(webp(lossless));
    for (const bool interlaced : {false, true}) {
        for (const auto& [colour, depth, bytes] :
             {std::make_tuple(PNG_COLOR_TYPE_RGB, 8, 24), std::make_tuple(PNG_COLOR_TYPE_RGB, 16, 48),
              std::make_tuple(PNG_COLOR_TYPE_RGB_ALPHA, 8, 32), std::make_tuple(PNG_COLOR_TYPE_RGB_ALPHA, 16, 64),
              std::make_tuple(PNG_COLOR_TYPE_GRAY, 1, 2), std::make_tuple(PNG_COLOR_TYPE_GRAY_ALPHA, 8, 16)}) {
            seeds.add(
                testing::png({colour, depth, interlaced}, 4, 2, std::vector<uint8_t>(static_cast<size_t>(bytes), 77)));
        }
        seeds.add(testing::png({PNG_COLOR_TYPE_PALETTE, 2, interlaced, {1, 2, 3, 4, 5, 6}, {7}}, 4, 2, {0x11, 0x44}));
    }
    for (const bool grey : {false, true})
        for (const bool progressive : {false, true}) seeds.add(testing::jpeg(40, 24, grey, progressive));
    const std::string scanline = std::string("\2\2\0\x08", 4) + "\x88\x40\x88\x20\x87\x10\1\x30\x88\x81";
    seeds.add("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n" + scanline + scanline);
    seeds.add("#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x80\x80\x80\x81\x81\x82\x83\x84");
    for (const Imf::Compression compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION,
          Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::DWAA_COMPRESSION})
        seeds.add(exr(compression));
}

constexpr char kObj[] =
    "mtllib m.mtl\nusemtl a\ns 1\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 1 1\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n"
    "f 1/1/1 2/2/1 3/3/1\nusemtl b c\ns off\nf 1//1 2//1 3//1 4//1\nf -1 -2 \\\n -3\n";
constexpr char kMtl[] =
    "newmtl a\nKd 0.5 0.4 0.3\nKs 1 1 1\nNs 90\nNi 1.5\nillum 7\nTf 0.9 0.9 0.9\nPr 0.3\nPm 0.5\nPc 1\nPcr 0.1\n"
    "Ps 0.4\naniso 0.6\nanisor 0.2\nKe 1 0 0\nd 0.5\nTr 0.5\nmap_Kd -s 2 2 1 -o 0 1 0 t.png\nmap_Bump -bm 0.5 t.png\n"
    "newmtl b c\nKd 1\nmap_Ns x\n";
constexpr char kJson[] = R"({"objects": [{"obj": "o.obj", "scale": 2, "rotate": [1, 2, 3], "translate": [0, 1, 0]}],
"up": "z", "environment": {"picture": "e.hdr", "rotate": 30, "scale": 2}, // sky
"lights": [{"type": "spot", "position": [0, 2, 0], "target": [0, 0, 0], "angle": 20, "intensity": 3},
{"type": "rectangle", "position": [3, 2, 0], "target": [0, 0, 0], "size": [1, 2], "radiance": [1, 2, 3]},
{"type": "point", "position": [3, 2, 0], "intensity": 1}, {"type": "directional", "direction": [0, 0, 1], "irradiance": 1},
{"type": "sphere", "position": [0, 4, 0], "radius": 0.5, "radiance": 9}],
"materials": {"a": {"metal": "gold", "roughness": 0.2, "anisotropy": 0.5, "sheen": 0.3, "glass": {"transmittance": 0.5, "at": 3}}},
"ground": {"radius": 3, "material": {"coat": 1}}, "exposure": 1.5, "tone": "aces",
"sphere": {"centre": [0, 0, 0], "radius": 99}})";

// Types of 1, 2, 4 and 8 bytes, integers and floats; packed by nothing, and by gzip's stored blocks.
void write_volumes(Seeds seeds)
{
    for (const auto& [type, bytes] : {std::make_pair(2, 1), std::make_pair(4, 2), std::make_pair(16, 4),
                                      std::make_pair(64, 8), std::make_pair(1280, 8)}) {
        std::string file =
            testing::nifti1_header({2, 3, 2}, static_cast<int16_t>(type), static_cast<int16_t>(8 * bytes));
        testing::put(file, testing::nifti1::kSlope, 2.0f);
        testing::put(file, type == 2 ? testing::nifti1::kQformCode : testing::nifti1::kSformCode, int16_t{1});
        for (size_t k = 0; k < 3; ++k) testing::put(file, testing::nifti1::kSrow + 20 * k, 1.5f);
        file.append(static_cast<size_t>(12 * bytes), 'x');
        seeds.add(file);
        const char length[] = {static_cast<char>(file.size()), static_cast<char>(file.size() >> 8),
                               static_cast<char>(~file.size()), static_cast<char>(~file.size() >> 8)};
        seeds.add(std::string("\x1F\x8B\x08\0\0\0\0\0\0\x03\x01", 11) + std::string(length, 4) + file);
    }
}

void write_rows(Seeds& seeds, lumi::TexelFormat texel)
{
    const testing::ScratchFolder folder;
    try {
        bake_field(testing::tiny_scene(), testing::tiny_settings(texel), folder.at("f"), testing::stop_after(40));
    } catch (const Cancelled&) {
    }
    for (const char kind : {'\0', '\2'}) seeds.add(kind + testing::read_bytes(folder.at("f.part")));
}

void write_shards(Seeds seeds)
{
    write_rows(seeds, lumi::TexelFormat::rgb888);
    write_rows(seeds, lumi::TexelFormat::palette8);
    FitBasis basis = {};
    basis.mesh.positions = {{0, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0}, {0.5f, 0.5f, 0}};
    basis.mesh.normals.assign(4, {0, 0, 1});
    basis.mesh.patches = {{0, 1, 2, 3}, {0, 1, 3, PatchMesh::kNone}};
    basis.mesh.longest_edge = 1;
    basis.densities = {4, 6};
    basis.sphere.radius = 1;
    const std::vector<uint8_t> head = encode(basis);
    const FitShape shape(basis.mesh, basis.densities);
    const EncodedTone tone(basis.tone);
    const FitState state(shape, tone);
    const std::vector<uint8_t> sums = encode(state);
    std::string bytes = {1, static_cast<char>(head.size()), static_cast<char>(head.size() >> 8)};
    seeds.add(bytes + std::string(head.begin(), head.end()) + std::string(sums.begin(), sums.end()));
}

// One input for each kind of network, and settings that say that there is none.
void write_weights(Seeds seeds)
{
    for (const char planes : {'\4', '\x0A'}) {
        std::string settings(64, '\0');
        settings[0] = 1;
        settings[4] = planes;
        seeds.add('\1' + settings);
        settings[8] = 1;
        seeds.add('\1' + settings + std::string(100, '\0'));
    }
}

void write_gltf(Seeds seeds)
{
    const std::string material =
        R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"scale":[2,2]}}}},)"
        R"("alphaMode":"MASK","normalTexture":{"index":0},"extensions":{"KHR_materials_ior":{"ior":1.4}})";
    testing::GltfMaker maker = testing::square(material, R"("children":[1])", R"(,{"mesh":0,"scale":[1,2,3]})");
    const std::string view = std::to_string(maker.view(testing::rgb_png(1, {1, 2, 3})));
    maker.add(R"("textures":[{"source":0}],"images":[{"bufferView":)" + view + "}]");
    seeds.add(maker.glb());
    seeds.add(testing::draco_gltf(testing::draco_square()).glb());
    seeds.add(testing::meshopt_square());
    testing::GltfMaker posed = testing::square("", R"("skin":0,"weights":[0.5])");
    posed.add(
        R"("skins":[{"joints":[0]}],"animations":[{"name":"a","samplers":[{"input":0,"output":0}],"channels":[]}])");
    seeds.add(posed.glb());
    seeds.add(testing::square().json("data:application/octet-stream;base64,AAAA"));
}

void write_facets(Seeds stl, Seeds ply)
{
    stl.add(testing::binary_stl());
    stl.add(testing::text_stl());
    ply.add(testing::text_ply());
    ply.add(testing::binary_ply<uint8_t>(false, "uchar"));
    ply.add(testing::binary_ply<int32_t>(true, "int"));
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fputs("usage: lumi_make_baker_corpus FOLDER\n", stderr);
        return 64;
    }
    const fs::path folder = argv[1];
    write_pictures(Seeds(folder / "picture"));
    Seeds(folder / "obj").add(std::string(kObj) + '\xFF' + kMtl);
    write_gltf(Seeds(folder / "gltf"));
    write_facets(Seeds(folder / "stl"), Seeds(folder / "ply"));
    Seeds(folder / "scene").add(kJson);
    write_volumes(Seeds(folder / "nifti"));
    write_shards(Seeds(folder / "shard"));
    write_weights(Seeds(folder / "weights"));
    return 0;
}
