// SPDX-License-Identifier: MIT
#include "image/picture_file.h"

#include <catch2/catch.hpp>

#include "metrics/psnr.h"

namespace lumi::tools
{

namespace
{

Picture ramps()
{
    Picture picture(64, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            for (int k = 0; k < 3; ++k) picture.pixel(x, y)[k] = static_cast<uint8_t>(x * (k + 1) + y);
    return picture;
}

}  // namespace

TEST_CASE("better JPEG takes more bytes, and a picture uses those that it may")
{
    const Picture picture = ramps();
    const size_t low = jpeg_bytes(picture, 10).size(), high = jpeg_bytes(picture, 90).size();
    REQUIRE(low < high);
    const double coarse = psnr_db(through_jpeg(picture, low), picture),
                 fine = psnr_db(through_jpeg(picture, high), picture);
    CHECK(coarse < fine);
    CHECK(fine > 25);
    CHECK(same_size(through_jpeg(picture, 1), picture));  // nothing fits: the worst quality
}

}  // namespace lumi::tools
