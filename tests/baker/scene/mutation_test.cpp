// SPDX-License-Identifier: MIT
// Damages scene, material and picture files at random, with fixed seeds: each loads or is refused with a message that
// names a file and a mend. Run it under the sanitizers.
#include <ImfRgbaFile.h>

#include <catch2/catch.hpp>

#include "image/radiance_picture.h"
#include "image/texture.h"
#include "math/sampler.h"
#include "math/warp.h"
#include "scene/scene_file.h"
#include "support/picture_bytes.h"
#include "support/scratch_folder.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{
namespace
{

constexpr char kObj[] = "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 1 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n";
constexpr char kMtl[] =
    "newmtl a\nKd 0.5 0.4 0.3\nKs 1 1 1\nNs 90\nNi 1.5\nillum 7\nTf 0.9 0.9 0.9\nPr 0.3\nPm 0.5\nPc 1\nPcr 0.1\nPs "
    "0.4\naniso 0.6\nanisor 0.2\n"
    "Ke 1 0 0\nd 0.5\nmap_Kd -s 2 2 1 t.png\nmap_Bump -bm 0.5 t.png\nmap_d t.png\nmap_Ps t.png\nnorm t.png\n";
constexpr char kJson[] = R"({"objects": [{"obj": "o.obj", "scale": 2, "rotate": [1, 2, 3], "translate": [0, 1, 0]}],
"up": "z", "environment": {"picture": "e.hdr", "rotate": 30, "scale": 2},
"lights": [{"type": "spot", "position": [0, 2, 0], "target": [0, 0, 0], "angle": 20, "intensity": 3},
{"type": "rectangle", "position": [3, 2, 0], "target": [0, 0, 0], "size": [1, 2], "radiance": [1, 2, 3]},
{"type": "sphere", "position": [0, 4, 0], "radius": 0.5, "radiance": 9}],
"materials": {"a": {"metal": "gold", "roughness": 0.2, "anisotropy": 0.5, "sheen": 0.3, "glass": {"transmittance": 0.5, "at": 3}}},
"ground": {"radius": 3, "material": {"coat": 1}}, "exposure": 1.5, "tone": "aces",
"sphere": {"centre": [0, 0, 0], "radius": 99}})";
const std::string kPixel = testing::rgb_png(1, {97, 98, 99});
const std::string kHdr = std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n") + "\x80\x80\x80\x81";

const std::string kWords[] = {"-1",
                              "0",
                              "1e999",
                              "nan",
                              "1e30",
                              "\"\"",
                              "{",
                              "}",
                              "[",
                              "]",
                              ",",
                              ":",
                              "//",
                              "\n",
                              "null",
                              "d",
                              "99999999999999999999",
                              "\"",
                              "\\",
                              "true",
                              "/*",
                              "#",
                              "-",
                              "1e-45"};

class Mutator
{
public:
    explicit Mutator(uint32_t seed) : sampler_(77, seed, 0) {}

    std::string damaged(std::string text)
    {
        for (size_t k = 0; k < 1 + below(3); ++k) {
            const size_t place = below(text.size() + 1);
            switch (below(4)) {
                case 0:
                    text = text.substr(0, place);
                    break;
                case 1:
                    text.erase(place, 1 + below(8));
                    break;
                case 2:
                    text.insert(place, kWords[below(std::size(kWords))]);
                    break;
                default:
                    text.replace(place, 1, 1, static_cast<char>(below(256)));
            }
        }
        return text;
    }

    size_t below(size_t count)
    {
        return std::min(static_cast<size_t>(sampler_.next_1d() * static_cast<float>(count)), count - 1);
    }

private:
    Sampler sampler_;
};

// A few paths through whatever has been loaded.
void trace_some(const Scene& scene)
{
    const PathTracer tracer(scene.data());
    for (uint32_t k = 0; k < 64; ++k) {
        Sampler sampler(5, k, 0);
        const Vec3 start = square_to_sphere(sampler.next_2d());
        const Vec3 target = square_to_sphere(sampler.next_2d()) * 0.3f;
        CHECK_FALSE(std::isnan(luminance(tracer.trace({start, normalized(target - start)}, sampler).radiance)));
    }
}

std::string exr_bytes(Imf::Compression compression)
{
    constexpr int kWidth = 24, kHeight = 40;  // more than one block of lines, of every compression
    const testing::ScratchFolder folder;
    std::vector<Imf::Rgba> pixels;
    for (int k = 0; k < kWidth * kHeight; ++k)
        pixels.emplace_back(0.01f * static_cast<float>(k), 1.0f / static_cast<float>(k + 1), 0.5f, 1.0f);
    {
        Imf::RgbaOutputFile out(folder.at("e.exr").c_str(), kWidth, kHeight, Imf::WRITE_RGB, 1, {0, 0}, 1,
                                Imf::INCREASING_Y, compression);
        out.setFrameBuffer(pixels.data(), 1, kWidth);
        out.writePixels(kHeight);
    }
    return testing::read_bytes(folder.at("e.exr"));
}

}  // namespace

TEST_CASE("mutation: damaged skies are read or refused with a message, whatever their compression")
{
    constexpr uint32_t kRounds = 60;
    const testing::ScratchFolder folder;
    std::vector<std::string> sound = {testing::read_bytes(LUMI_SCENES "/gallery_sky.hdr")};
    for (const Imf::Compression compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION,
          Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::DWAA_COMPRESSION})
        sound.push_back(exr_bytes(compression));
    size_t read = 0, refused = 0;
    for (size_t kind = 0; kind < sound.size(); ++kind) {
        for (uint32_t round = 0; round < kRounds; ++round) {
            Mutator mutator(static_cast<uint32_t>(1000 * kind) + round);
            INFO("kind " << kind << ", round " << round);
            try {
                std::vector<std::string> warnings;
                const RadiancePicture picture =
                    read_radiance_picture(folder.write("e.exr", mutator.damaged(sound[kind])), warnings);
                REQUIRE(picture.pixels.size() ==
                        static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height));
                for (const Rgb& c : picture.pixels)
                    REQUIRE((std::isfinite(c.r + c.g + c.b) && std::min({c.r, c.g, c.b}) >= 0));
                ++read;
            } catch (const SceneError& e) {
                CHECK_THAT(e.what(), Catch::Contains("e.exr") && Catch::Contains("; "));
                ++refused;
            }
        }
    }
    CHECK(read > kRounds / 2);
    CHECK(refused > kRounds / 2);
}

TEST_CASE("mutation: damaged textures are read or refused with a reason")
{
    const testing::ScratchFolder folder;
    const std::string sound[] = {testing::read_bytes(LUMI_SCENES "/gallery_holes.png"), testing::jpeg(40, 30)};
    for (const std::string& picture : sound) {
        size_t read = 0, refused = 0;
        for (uint32_t round = 0; round < 300; ++round) {
            Mutator mutator(round);
            try {
                const Texture texture = read_texture(folder.write("t", mutator.damaged(picture)), PictureUse::alpha);
                CHECK(texture.rgb.size() == static_cast<size_t>(3 * texture.width * texture.height));
                ++read;
            } catch (const PictureError& e) {
                CHECK_FALSE(std::string(e.what()).empty());
                ++refused;
            }
        }
        INFO(read << " read, " << refused << " refused");
        CHECK((read > 5 || &picture == &sound[0]));  // a PNG's checksums find every change
        CHECK(refused > 100);
    }
}

TEST_CASE("mutation: damaged scene, material and picture files load or are refused with a message")
{
    constexpr uint32_t kRounds = 250;
    const testing::ScratchFolder folder;
    size_t loaded = 0, refused = 0;
    for (uint32_t round = 0; round < kRounds; ++round) {
        Mutator mutator(round);
        const size_t target = mutator.below(5);
        const auto text = [&](size_t which, const std::string& sound) {
            return which == target ? mutator.damaged(sound) : sound;
        };
        folder.write("s.json", text(0, kJson));
        folder.write("m.mtl", text(1, kMtl));
        folder.write("e.hdr", text(2, kHdr));
        folder.write("t.png", text(3, kPixel));
        folder.write("o.obj", text(4, kObj));
        INFO("round " << round);
        try {
            std::vector<std::string> warnings;
            const Scene scene = load_scene(folder.at("s.json"), {}, warnings);
            CHECK(scene.triangle_count() > 0);
            CHECK(std::isfinite(scene.radius()));
            trace_some(scene);
            ++loaded;
        } catch (const SceneError& e) {
            CHECK_THAT(e.what(), Catch::Contains("; "));
            ++refused;
        }
    }
    CHECK(loaded > kRounds / 10);
    CHECK(refused > kRounds / 10);
}

}  // namespace lumi::baker
