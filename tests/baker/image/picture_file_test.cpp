// SPDX-License-Identifier: MIT
#include "lumi/baker/picture_file.h"

#include <png.h>

#include <catch2/catch.hpp>

#include "image/picture_bytes.h"
#include "image/radiance_picture.h"
#include "image/texture.h"
#include "lumi/baker/scene.h"
#include "support/picture_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using PictureBytes = std::vector<uint8_t>;
using testing::png;
using testing::ScratchFolder;

Texture read(const std::string& bytes, PictureUse use = PictureUse::data)
{
    const ScratchFolder folder;
    return read_texture(folder.write("t", bytes), use);
}

std::string refusal(const std::string& name, const std::string& bytes)
{
    const ScratchFolder folder;
    try {
        read_texture(folder.write(name, bytes), PictureUse::colour);
    } catch (const PictureError& e) {
        return e.what();
    }
    return "it was read";
}

std::string be32(uint32_t v)
{
    return {static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8), static_cast<char>(v)};
}

std::string chunk(const std::string& name_and_data)
{
    const auto* bytes = reinterpret_cast<const png_byte*>(name_and_data.data());
    uint32_t crc = 0xFFFFFFFFu;
    for (size_t k = 0; k < name_and_data.size(); ++k) {
        crc ^= bytes[k];
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (0xEDB88320u & (0u - (crc & 1)));
    }
    return be32(static_cast<uint32_t>(name_and_data.size()) - 4) + name_and_data + be32(~crc);
}

// A sound header and nothing more.
std::string png_claiming(uint32_t width, uint32_t height)
{
    return "\x89PNG\r\n\x1A\n" + chunk("IHDR" + be32(width) + be32(height) + std::string("\x08\x02\0\0\0", 5)) +
           chunk("IDAT");
}

// 8 pixels wide, two scanlines, with runs.
std::string packed_hdr()
{
    const std::string scanline =
        std::string("\2\2\0\x08", 4) + "\x88\x40" + "\x88\x20" + "\x87\x10" + "\1\x30" + "\x88\x81";
    return "#?RADIANCE\nSOFTWARE=x\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n" + scanline + scanline;
}

}  // namespace

TEST_CASE("picture file: every kind of PNG gives the same pixels")
{
    const PictureBytes rgb = {255, 0, 0, 0, 255, 0, 51, 102, 153, 0, 0, 0};
    CHECK((read(png({PNG_COLOR_TYPE_RGB}, 2, 2, rgb)).rgb == rgb));
    CHECK((read(png({PNG_COLOR_TYPE_RGB, 8, true}, 2, 2, rgb)).rgb == rgb));
    PictureBytes wide, with_alpha, alpha;
    for (size_t k = 0; k < rgb.size(); ++k) {
        wide.insert(wide.end(), {rgb[k], rgb[k]});  // v · 257 in 16 bits
        with_alpha.push_back(rgb[k]);
        if (k % 3 == 2) {
            with_alpha.push_back(static_cast<uint8_t>(20 * k));
            alpha.insert(alpha.end(), 3, static_cast<uint8_t>(20 * k));
        }
    }
    CHECK((read(png({PNG_COLOR_TYPE_RGB, 16}, 2, 2, wide)).rgb == rgb));
    for (const bool interlaced : {false, true}) {
        const std::string file = png({PNG_COLOR_TYPE_RGB_ALPHA, 8, interlaced}, 2, 2, with_alpha);
        CHECK((read(file).rgb == rgb));
        CHECK((read(file, PictureUse::alpha).rgb == alpha));
    }
    const testing::PngKind indexed = {PNG_COLOR_TYPE_PALETTE, 2, false, rgb, {7, 8}};
    CHECK((read(png(indexed, 4, 1, {0x1B})).rgb == rgb));
    CHECK((read(png(indexed, 4, 1, {0x1B}), PictureUse::alpha).rgb ==
           PictureBytes{7, 7, 7, 8, 8, 8, 255, 255, 255, 255, 255, 255}));
    CHECK((read(png({PNG_COLOR_TYPE_GRAY, 1}, 2, 1, {0x40})).rgb == PictureBytes{0, 0, 0, 255, 255, 255}));
    CHECK((read(png({PNG_COLOR_TYPE_GRAY_ALPHA}, 1, 1, {9, 60}), PictureUse::alpha).rgb == PictureBytes{60, 60, 60}));
    CHECK((read(png({PNG_COLOR_TYPE_GRAY}, 1, 1, {9}), PictureUse::alpha).rgb == PictureBytes{9, 9, 9}));
}

TEST_CASE("picture file: JPEG, grey and coloured, sequential and progressive")
{
    for (const bool grey : {false, true}) {
        for (const bool progressive : {false, true}) {
            const Texture t = read(testing::jpeg(64, 48, grey, progressive), PictureUse::colour);
            REQUIRE(t.width == 64);
            REQUIRE(t.height == 48);
            const uint8_t* right = &t.rgb[3 * (64 * 24 + 60)];
            CHECK(std::abs(right[0] - (grey ? 157 : 239)) < 12);  // 0.299 · 239 + 0.587 · 127 + 0.114 · 90
            CHECK(is_grey(t) == grey);
        }
    }
}

TEST_CASE("picture file: OpenEXR is read as it was written, beyond white and to the last bit")
{
    // 3 by 2 pixels; the alpha of each is 1/2.
    std::vector<float> rgba;
    for (int k = 0; k < 6; ++k) rgba.insert(rgba.end(), {0.1f * static_cast<float>(k), 70000.0f, 1e-6f, 0.5f});
    const std::string bytes = exr_bytes({3, 2, rgba.data()});
    REQUIRE(is_exr(bytes));
    const RadiancePicture read = decode_exr(bytes);
    REQUIRE(read.width == 3);
    REQUIRE(read.height == 2);
    for (size_t k = 0; k < 6; ++k) {
        CHECK(read.pixels[k].r == rgba[4 * k]);
        CHECK(read.pixels[k].g == 70000.0f);
        CHECK(read.pixels[k].b == 1e-6f);
    }
}

TEST_CASE("picture file: other formats are refused by name, before a pixel is read")
{
    // 16 bits a channel: the reader of old read 2 bytes a channel where it had allocated one.
    CHECK_THAT(refusal("t.ppm", "P6\n4 4\n65535\n" + std::string(24, 'x')), Catch::Contains("a PNM picture"));
    // 18 bytes that claim 23,000 by 23,000 pixels: the reader of old took 3.6 GB and 42 s.
    const std::string tga = std::string("\0\0\2\0\0\0\0\0\0\0\0\0", 12) + "\xD8\x59\xD8\x59" + std::string("\x18\0", 2);
    CHECK_THAT(refusal("t.TGA", tga), Catch::Contains("a TGA picture"));
    CHECK_THAT(refusal("t.bmp", "BM......"), Catch::Contains("a BMP picture"));
    CHECK_THAT(refusal("t.gif", "GIF89a.."), Catch::Contains("a GIF picture"));
    CHECK_THAT(refusal("t.png", packed_hdr()), Catch::Contains("a Radiance picture"));
    CHECK_THAT(refusal("t.png", ""), Catch::Contains("neither PNG nor JPEG"));
    const ScratchFolder folder;
    CHECK_THROWS_AS(read_texture(folder.at(""), PictureUse::colour), PictureError);
}

TEST_CASE("picture file: sizes are checked before memory is taken")
{
    CHECK_THAT(refusal("t.png", png_claiming(32769, 1)), Catch::Contains("damaged"));  // libpng's words
    CHECK_THAT(refusal("t.png", png_claiming(12000, 12000)), Catch::Contains("too large; at most 32768 a side"));
    CHECK_THAT(refusal("t.png", png_claiming(11000, 11000)), Catch::Contains("ends too early"));
    CHECK_THAT(refusal("t.png", png_claiming(0, 1)), Catch::Contains("damaged"));
    std::string large_jpeg = testing::jpeg(16, 16);
    const size_t frame = large_jpeg.find("\xFF\xC0");
    REQUIRE(frame != std::string::npos);
    large_jpeg.replace(frame + 5, 4, "\xFF\xDC\xFF\xDC");
    CHECK_THAT(refusal("t.jpg", large_jpeg), Catch::Contains("65500 by 65500 pixels is too large"));
    CHECK_THROWS_WITH(decode_hdr("#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 10000 +X 10000\n\2\2\0\1"),
                      Catch::Contains("ends too early"));
    CHECK_THROWS_WITH(decode_hdr("#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 20000 +X 20000\n"),
                      Catch::Contains("too large"));
}

TEST_CASE("picture file: a sparse file of 6 GB is refused before it is read")
{
    const ScratchFolder folder;
    const std::filesystem::path file = folder.write("t.png", png_claiming(4, 4));
    std::filesystem::resize_file(file, uintmax_t{6} << 30);
    CHECK_THROWS_WITH(read_texture(file, PictureUse::colour), Catch::Contains("more than 1073741824 bytes"));
    CHECK_THROWS_WITH(read_png(file), Catch::Contains("more than 1073741824 bytes"));
    std::vector<std::string> warnings;
    CHECK_THROWS_WITH(read_radiance_picture(file, warnings), Catch::Contains("more than 1073741824 bytes"));
}

TEST_CASE("picture file: every truncation of PNG, JPEG and HDR is refused")
{
    const std::string sound[] = {png({PNG_COLOR_TYPE_RGB}, 2, 2, PictureBytes(12, 7)), testing::jpeg(20, 12),
                                 testing::jpeg(20, 12, false, true)};
    for (const std::string& picture : sound) {
        CHECK(refusal("t", picture) == "it was read");
        for (size_t size = 0; size + 2 < picture.size(); ++size) {  // a JPEG without its end marker is whole
            INFO("size " << size << " of " << picture.size());
            CHECK(refusal("t", picture.substr(0, size)) != "it was read");
        }
    }
    const std::string hdr = packed_hdr();
    for (size_t size = 0; size < hdr.size(); ++size)  // the reader of old never ended
        CHECK_THROWS_AS(decode_hdr(hdr.substr(0, size)), PictureError);
}

TEST_CASE("picture file: an HDR picture with run lengths")
{
    const RadiancePicture picture = decode_hdr(packed_hdr());
    REQUIRE(picture.width == 8);
    REQUIRE(picture.height == 2);
    CHECK(picture.at(0, 0).r == 0.5f);
    CHECK(picture.at(7, 1).g == 0.25f);
    CHECK(picture.at(6, 1).b == 0.125f);
    CHECK(picture.at(7, 1).b == 0.375f);
    CHECK_THROWS_WITH(decode_hdr("#?RGBE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n...."),
                      Catch::Contains("lacks 'FORMAT"));
    CHECK_THROWS_WITH(decode_hdr("#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n+X 1 -Y 1\n...."), Catch::Contains("of the form"));
    CHECK_THROWS_WITH(decode_hdr("#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\1\1\1\5"),
                      Catch::Contains("first version"));
}

TEST_CASE("pictures of a model: together they have room for honest ones, and refuse what few bytes claim")
{
    constexpr int64_t kSide = 4096, kPixels = kSide * kSide;
    PictureRoom room("model.obj");
    for (int k = 0; k < 200; ++k) {  // photographs, packed as far as that looks good, each used for two things
        room.add(kPixels / 16);
        room.take(2 * kPixels);
    }
    PictureRoom flat("model.obj");
    for (int k = 0; k < 9; ++k) flat.take(kPixels);  // of one colour, so in no bytes to speak of
    CHECK_THROWS_WITH(flat.take(kPixels),
                      Catch::StartsWith("model.obj: its pictures are too large in all") && Catch::Contains("; make"));
    CHECK(pixels_of(png_claiming(3, 7)) == 21);
    CHECK(pixels_of(png_claiming(0xFFFFFFFF, 0xFFFFFFFF)) == 0);
    const ScratchFolder folder;
    const auto file = folder.write("t", png_claiming(8192, 8192));
    PictureRoom of_files("model.obj");
    for (int k = 0; k < 2; ++k) CHECK_THROWS_AS(read_texture(file, PictureUse::colour, &of_files), PictureError);
    CHECK_THROWS_AS(read_texture(file, PictureUse::colour, &of_files), SceneError);
}

}  // namespace lumi::baker
