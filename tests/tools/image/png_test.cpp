// SPDX-License-Identifier: MIT
#include "image/picture_file.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "lumi/host/png.h"
#include "support/temporary_folder.h"
#include "support/test_pictures.h"
#include "terminal/failure.h"

namespace lumi::tools
{

TEST_CASE("a picture written as PNG reads back byte for byte, for any shape")
{
    const test::TemporaryFolder folder;
    for (const auto& [width, height] : {std::make_pair(1, 1), std::make_pair(3, 200), std::make_pair(257, 2)}) {
        const Picture picture = test::random_picture(width, height, 8);
        write_png(folder / "a.png", picture);
        const Picture read = read_png(folder / "a.png");
        CHECK(same_size(picture, read));
        CHECK((picture.rgb == read.rgb));
    }
}

TEST_CASE("a PNG keeps alpha, and is read as it looks over black")
{
    const test::TemporaryFolder folder;
    Picture picture = test::random_picture(5, 4, 8);
    for (uint8_t k = 0; k < 20; ++k) picture.alpha.push_back(static_cast<uint8_t>(k * 13));
    write_png(folder / "a.png", picture);
    const auto decoded = host::decode_png(test::content_of(folder / "a.png"), true);
    CHECK((decoded.rgb == picture.rgb));
    CHECK((decoded.alpha == picture.alpha));
    const Picture black = read_png(folder / "a.png");
    CHECK(black.alpha.empty());
    for (size_t i = 0; i < black.rgb.size(); ++i)
        CHECK(black.rgb[i] == std::lround(picture.rgb[i] * picture.alpha[i / 3] / 255.0));
}

TEST_CASE("a PNG of a smooth picture is much smaller than its pixels")
{
    Picture picture(256, 256);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            const auto grey = static_cast<uint8_t>((x + y) / 2);
            std::fill_n(picture.rgb.begin() + 3 * (256 * y + x), 3, grey);
        }
    CHECK(png_bytes(picture).size() < picture.rgb.size() / 100);  // stb's own packer comes to 1/40
}

TEST_CASE("a picture that stb_image_write cannot count is refused by its size")
{
    const uint8_t pixel[3] = {};  // no other is read
    const auto refusal = [&](int width, int height) { return host::png_bytes({width, height, pixel}); };
    CHECK_THROWS_AS(refusal(5592406, 1), std::length_error);    // the sum of a row's magnitudes
    CHECK_THROWS_AS(refusal(32768, 32768), std::length_error);  // 3 GB
    CHECK_THROWS_WITH(refusal(26755, 26755), "a picture of 26755 by 26755 pixels is too large for a PNG file");  // 2 GB
}

TEST_CASE("what is not a whole PNG is refused by name")
{
    const test::TemporaryFolder folder;
    write_png(folder / "whole.png", test::random_picture(20, 20, 1));
    const std::string whole = test::content_of(folder / "whole.png");
    for (const std::string& bytes : {std::string(), std::string("hello"), whole.substr(0, whole.size() / 2)}) {
        test::write_content(folder / "bad.png", bytes);
        CHECK_THROWS_WITH(read_png(folder / "bad.png"), Catch::Contains("bad.png"));
    }
    CHECK_THROWS_AS(read_png(folder / "missing.png"), Failure);
    CHECK_THROWS_AS(read_png(folder.path()), Failure);
}

}  // namespace lumi::tools
