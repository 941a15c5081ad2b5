// SPDX-License-Identifier: MIT
#include "image/picture.h"

#include <catch2/catch.hpp>

#include "support/test_pictures.h"

namespace lumi::tools
{

TEST_CASE("shrinking takes the rounded mean of each block")
{
    Picture picture(4, 2);
    const uint8_t values[8] = {0, 1, 10, 20, 1, 1, 30, 40};
    for (int i = 0; i < 8; ++i) picture.pixel(i % 4, i / 4)[1] = values[i];
    const Picture small = shrunk(picture, 2);
    REQUIRE(small.width_px == 2);
    REQUIRE(small.height_px == 1);
    CHECK(small.pixel(0, 0)[1] == 1);  // 3/4
    CHECK(small.pixel(1, 0)[1] == 25);
    CHECK(small.pixel(1, 0)[0] == 0);
}

TEST_CASE("a contact sheet shows every picture once, row by row, on the background")
{
    ContactSheet sheet(7, 10, 8, {9, 9, 9});
    for (uint8_t i = 0; i < 7; ++i) sheet.add(Picture(10, 8, {static_cast<uint8_t>(100 + i), 0, 0}));
    const Picture& picture = sheet.picture();
    REQUIRE(picture.width_px == 3 * 10 + 2 * kSheetGap);
    REQUIRE(picture.height_px == 3 * 8 + 2 * kSheetGap);
    for (int i = 0; i < 7; ++i) {
        const int x = i % 3 * (10 + kSheetGap), y = i / 3 * (8 + kSheetGap);
        CHECK(picture.pixel(x, y)[0] == 100 + i);
        CHECK(picture.pixel(x + 9, y + 7)[0] == 100 + i);
    }
    CHECK(picture.pixel(10, 0)[0] == 9);                                        // a gap
    CHECK(picture.pixel(picture.width_px - 1, picture.height_px - 1)[0] == 9);  // no eighth picture
}

TEST_CASE("a contact sheet over nothing counts colours by their alpha, and nothing is in its gaps")
{
    Picture picture(2, 2, {90, 0, 0});
    picture.alpha = {0, 200, 200, 200};
    picture.pixel(0, 0)[0] = 7;  // is not seen
    const Picture small = shrunk(picture, 2);
    CHECK(small.pixel(0, 0)[0] == 90);
    CHECK(small.alpha_at(0, 0) == 150);
    ContactSheet sheet(2, 2, 2, {0, 0, 0}, false);
    for (int k = 0; k < 2; ++k) sheet.add(picture);
    const Picture& drawn = sheet.picture();
    CHECK(drawn.alpha_at(1, 1) == 200);
    CHECK(drawn.alpha_at(2, 1) == 0);
    CHECK(drawn.alpha_at(2 + kSheetGap, 1) == 200);
}

TEST_CASE("a contact sheet of large pictures is shrunk to its widest width")
{
    for (const int width : {1, 100, 1000, 8192}) {
        const int count = GENERATE(1, 2, 36, 400);
        const ContactSheet sheet(count, width, 300, {0, 0, 0});
        CHECK(sheet.picture().width_px <= std::max(kSheetMaxWidth, width == 1 ? 400 * (1 + kSheetGap) : 0));
        CHECK(sheet.picture().height_px >= 1);
    }
}

}  // namespace lumi::tools
