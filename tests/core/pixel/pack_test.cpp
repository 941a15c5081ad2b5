// SPDX-License-Identifier: MIT
#include "lumi/pack.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "lumi/pixel.h"

using namespace lumi;

namespace
{

using Bytes = std::vector<uint8_t>;
constexpr int32_t kWidth = 40, kHeight = 24;

Bytes flat(uint8_t value)
{
    return Bytes(size_t{kWidth * kHeight}, value);
}

Stripe stripe_of(Bytes& grey, int32_t y = 0, int32_t rows = kHeight)
{
    return {grey.data() + y * kWidth, 0, y, kWidth, rows, kWidth};
}

double mean16(uint8_t value)
{
    Bytes grey = flat(value), out(grey4_bytes(kWidth) * kHeight);
    pack_grey4(stripe_of(grey), out.data(), grey4_bytes(kWidth));
    double sum = 0;
    for (const uint8_t b : out) sum += (b >> 4) + (b & 15);
    return sum / (kWidth * kHeight);
}

double mean_light(uint8_t value)
{
    Bytes grey = flat(value), out(mono1_bytes(kWidth) * kHeight);
    pack_mono1(stripe_of(grey), out.data(), mono1_bytes(kWidth));
    double sum = 0;
    for (const uint8_t b : out) sum += __builtin_popcount(b);
    return sum / (kWidth * kHeight);
}

}  // namespace

TEST_CASE("a dithered area has the mean that it stands for")
{
    double worst16 = 0, worst2 = 0;
    for (uint32_t v = 0; v < 256; ++v) {
        worst16 = std::max(worst16, std::abs(mean16(static_cast<uint8_t>(v)) - 15.0 * v / 255));
        worst2 = std::max(worst2, std::abs(mean_light(static_cast<uint8_t>(v)) - v / 255.0));
    }
    CHECK(worst16 < 1.5 / 64);  // 64 thresholds
    CHECK(worst2 < 1.5 / 64);
    CHECK(mean16(0) == 0);
    CHECK(mean16(255) == 15);
    CHECK(mean_light(0) == 0);
    CHECK(mean_light(255) == 1);
}

TEST_CASE("pixels lie where displays look for them")
{
    Bytes grey(9, 0);
    grey[0] = grey[8] = 255;
    uint8_t four[5] = {}, one[2] = {};
    pack_grey4({grey.data(), 0, 0, 9, 1, 9}, four, 5);
    pack_mono1({grey.data(), 0, 0, 9, 1, 9}, one, 2);
    CHECK((four[0] == 0xF0 && four[1] == 0 && four[4] == 0xF0));
    CHECK((one[0] == 0x80 && one[1] == 0x80));
    Bytes column(16, 0);
    column[0] = column[15] = 255;
    uint8_t pages[2] = {};
    pack_pages({column.data(), 0, 0, 1, 16, 1}, pages, 1);
    CHECK((pages[0] == 0x01 && pages[1] == 0x80));
}

TEST_CASE("packing is the same in place, and however a frame is cut into stripes")
{
    Bytes grey;
    for (int32_t k = 0; k < kWidth * kHeight; ++k) grey.push_back(static_cast<uint8_t>(k * 7 % 256));
    const auto whole = [&](auto pack, uint32_t stride) {
        Bytes out(stride * kHeight);
        pack(stripe_of(grey), out.data(), stride);
        return out;
    };
    const auto cut = [&](auto pack, uint32_t stride) {
        Bytes out(stride * kHeight);
        for (int32_t y = 0; y < kHeight; y += 8) {
            Bytes copy = grey;
            const Stripe stripe = stripe_of(copy, y, 8);
            pack(stripe, stripe.pixels, stride);
            std::copy(stripe.pixels, stripe.pixels + 8 * stride, out.begin() + static_cast<long>(stride) * y);
        }
        return out;
    };
    CHECK((whole(pack_grey4, grey4_bytes(kWidth)) == cut(pack_grey4, grey4_bytes(kWidth))));
    CHECK((whole(pack_mono1, mono1_bytes(kWidth)) == cut(pack_mono1, mono1_bytes(kWidth))));
    Bytes once(kWidth * kHeight / 8);
    pack_pages(stripe_of(grey), once.data(), kWidth);
    for (int32_t y = 0; y < kHeight; y += 8) {
        Bytes copy = grey;
        const Stripe stripe = stripe_of(copy, y, 8);
        pack_pages(stripe, stripe.pixels, kWidth);
        CHECK((std::equal(stripe.pixels, stripe.pixels + kWidth, once.begin() + y / 8 * kWidth)));
    }
}

TEST_CASE("dithered colours have the mean that they stand for, and black and white stay so")
{
    double worst = 0;
    for (uint32_t v = 0; v < 256; ++v) {
        const uint8_t channels[] = {static_cast<uint8_t>(v), static_cast<uint8_t>(255 - v),
                                    static_cast<uint8_t>(v / 2)};
        Bytes rgb(64 * 3), pixels(64 * 2);
        for (size_t k = 0; k < rgb.size(); ++k) rgb[k] = channels[k % 3];
        dither_rgb565({rgb.data(), 8, 16, 8, 8, 24}, pixels.data(), 16);
        double sums[3] = {};
        for (size_t k = 0; k < 64; ++k) {
            const uint16_t packed = PixelRgb565::load_packed(pixels.data() + 2 * k);
            sums[0] += (packed >> 11) / 31.0, sums[1] += (packed >> 5 & 63) / 63.0, sums[2] += (packed & 31) / 31.0;
            if (v == 0) CHECK(packed == 63 << 5);
        }
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(sums[c] / 64 - channels[c] / 255.0) * 31);
    }
    CHECK(worst < 1.5 / 64);  // in steps: 64 thresholds
}

TEST_CASE("dither is the same in place, in either order of bytes, and however a frame is cut into stripes")
{
    Bytes rgb, whole(2 * kWidth * kHeight), swapped(whole.size()), cut(whole.size());
    for (int32_t k = 0; k < 3 * kWidth * kHeight; ++k) rgb.push_back(static_cast<uint8_t>(k * 7 % 256));
    dither_rgb565({rgb.data(), 0, 0, kWidth, kHeight, 3 * kWidth}, whole.data(), 2 * kWidth);
    dither_rgb565_swapped({rgb.data(), 0, 0, kWidth, kHeight, 3 * kWidth}, swapped.data(), 2 * kWidth);
    for (size_t k = 0; k < whole.size(); ++k) REQUIRE(whole[k] == swapped[k ^ 1]);
    for (int32_t y = 0; y < kHeight; y += 3)
        for (int32_t x = 0; x < kWidth; x += 10) {
            Bytes part;
            for (int32_t row = y; row < y + 3; ++row)
                part.insert(part.end(), rgb.begin() + 3 * (row * kWidth + x),
                            rgb.begin() + 3 * (row * kWidth + x + 10));
            dither_rgb565({part.data(), x, y, 10, 3, 30}, part.data(), 20);
            for (int32_t row = 0; row < 3; ++row)
                std::copy_n(part.begin() + 20 * row, 20, cut.begin() + 2 * ((y + row) * kWidth + x));
        }
    CHECK((cut == whole));
}
