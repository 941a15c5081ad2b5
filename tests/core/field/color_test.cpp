// SPDX-License-Identifier: MIT
#include "lumi/color.h"

#include <catch2/catch.hpp>

#include "lumi/background.h"
#include "lumi/chord/texel.h"
#include "lumi/pixel.h"

using namespace lumi;
using namespace lumi::detail;

namespace
{

bool same(const Rgb8& a, const Rgb8& b)
{
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

int difference(uint8_t a, uint8_t b)
{
    return a < b ? b - a : a - b;
}

}  // namespace

TEST_CASE("RGB565 packing rounds to nearest and survives a round trip", "[color]")
{
    bool stable = true;
    for (uint32_t v = 0; v < 65536; ++v) stable = stable && pack_rgb565(unpack_rgb565(static_cast<uint16_t>(v))) == v;
    CHECK(stable);
    int worst = 0;
    for (int c = 0; c < 256; ++c) {
        const uint8_t u = static_cast<uint8_t>(c);
        const Rgb8 back = unpack_rgb565(pack_rgb565({u, u, u}));
        worst = std::max({worst, difference(back.r, u), 2 * difference(back.g, u) - 1, difference(back.b, u)});
    }
    CHECK(worst <= 4);  // half a step of 8.2 (and of 4.05 for green)
}

TEST_CASE("luma keeps grey and the ends of the range", "[color]")
{
    bool grey = true;
    for (int c = 0; c < 256; ++c) {
        const uint8_t u = static_cast<uint8_t>(c);
        grey = grey && luma({u, u, u}) == u;
    }
    CHECK(grey);
    CHECK(luma({0, 255, 0}) > luma({255, 0, 0}));
    CHECK(luma({255, 0, 0}) > luma({0, 0, 255}));
}

TEST_CASE("pixel formats store and load the same colour", "[pixel]")
{
    const Rgb8 colour = {200, 100, 50};
    alignas(2) uint8_t bytes[6] = {};
    PixelRgb565::store(bytes + 2, colour);
    CHECK(bytes[2] == (pack_rgb565(colour) & 255));
    CHECK(same(PixelRgb565::load(bytes + 2), unpack_rgb565(pack_rgb565(colour))));
    PixelRgb565Swapped::store(bytes + 2, colour);
    CHECK(bytes[2] == pack_rgb565(colour) >> 8);
    CHECK(same(PixelRgb565Swapped::load(bytes + 2), unpack_rgb565(pack_rgb565(colour))));
    PixelRgb888::store(bytes + 1, colour);
    CHECK(same(PixelRgb888::load(bytes + 1), colour));
    PixelGrey8::store(bytes + 1, colour);
    CHECK(bytes[1] == luma(colour));
}

TEST_CASE("black texels stay visible and every encoded colour is covered", "[texel]")
{
    const Rgb8 black = {0, 0, 0};
    const Field none;
    const Rgb8 darkest888 = TexelRgb888::encode(black);
    const uint8_t row888[] = {darkest888.r, darkest888.g, darkest888.b};
    CHECK(TexelRgb888::load(none, row888, 0).a == 255);
    const uint16_t darkest565 = TexelRgb565::encode(black);
    const uint8_t row565[] = {static_cast<uint8_t>(darkest565), static_cast<uint8_t>(darkest565 >> 8)};
    CHECK(TexelRgb565::load(none, row565, 0).a == 255);
    const uint8_t row8[] = {TexelLuma8::encode(black)};
    CHECK(TexelLuma8::load(none, row8, 0).a == 255);

    for (uint32_t level = 0; level < 256; ++level) {  // at run time, as a baker encodes
        const uint8_t c = static_cast<uint8_t>(level);
        const Rgb8 v = TexelRgb888::encode({c, c, c});
        CHECK((v.r == c && v.g == c && v.b == (c == 0 ? 1 : c)));
        CHECK((TexelRgb565::encode({c, c, c}) == 0) == false);
    }

    const uint8_t miss[3] = {0, 0, 0};
    CHECK(TexelRgb888::load(none, miss, 0).a == 0);
    CHECK(TexelRgb565::load(none, miss, 0).a == 0);
    CHECK(TexelLuma8::load(none, miss, 0).a == 0);
}
