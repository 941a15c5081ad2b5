// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "chord/texel_tracer.h"
#include "image/texture.h"
#include "lumi/chord/texel.h"
#include "trace/error_gauge.h"

namespace lumi::baker
{

TEST_CASE("srgb: decoding and encoding every value gives it back")
{
    for (int v = 0; v < 256; ++v) {
        const float linear = srgb_decode(static_cast<uint8_t>(v));
        CHECK(srgb_encode({linear, linear, linear}).g == v);
    }
    CHECK(static_cast<double>(srgb_decode(188)) == Approx(0.5029).epsilon(1e-3));
    CHECK(srgb_encode({-1, 2, std::nanf("")}).r == 0);
    CHECK(srgb_encode({-1, 2, std::nanf("")}).g == 255);
    CHECK(srgb_encode({-1, 2, std::nanf("")}).b == 0);
}

TEST_CASE("texture: v points up, pixel centres give pixels, the picture repeats, neighbours blend in linear light")
{
    const Texture t = {2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}};
    const auto at = [&](float u, float v) { return srgb_encode(t.at({u, v})); };
    CHECK(at(0.25f, 0.75f).r == 255);
    CHECK(at(0.25f, 0.75f).g == 0);
    CHECK(at(0.75f, 0.75f).g == 255);
    CHECK(at(0.25f, 0.25f).b == 255);
    CHECK(at(0.75f, 0.25f).r == 255);
    CHECK(at(3.25f, -7.25f).r == 255);
    CHECK(at(3.25f, -7.25f).g == 0);
    CHECK(static_cast<double>(t.at({0.5f, 0.75f}).r) == Approx(0.5));
    CHECK(static_cast<double>(t.at({0, 0.75f}).g) == Approx(0.5));
}

TEST_CASE("texture: beyond its border a picture repeats, holds its outermost pixels, or is mirrored")
{
    const Texture t = {3, 1, {0, 0, 0, 100, 0, 0, 200, 0, 0}, false};
    const auto at = [&](float pixel, Wrap wrap) {
        return std::lround(t.at({(pixel + 0.5f) / 3, 0.5f}, {wrap, Wrap::repeat}).r * 255);
    };
    const long mirrored[] = {0, 100, 200, 200, 100, 0};
    for (int k = -12; k < 12; ++k) {
        INFO(k);
        const size_t in_period = static_cast<size_t>(k + 12) % 6;
        CHECK(at(static_cast<float>(k), Wrap::repeat) == 100 * static_cast<long>(in_period % 3));
        CHECK(at(static_cast<float>(k), Wrap::clamp) == 100 * std::clamp(k, 0, 2));
        CHECK(at(static_cast<float>(k), Wrap::mirror) == mirrored[in_period]);
    }
    CHECK(at(-0.5f, Wrap::repeat) == 100);
    CHECK(at(-0.5f, Wrap::mirror) == 0);
    CHECK(at(1e9f, Wrap::clamp) == 200);
    CHECK(at(2.5f, Wrap::clamp) == 200);
}

TEST_CASE("estimate: coverage counts hits, colour is the mean of the hits alone")
{
    Estimate e;
    CHECK_FALSE(e.mostly_covered());
    CHECK(e.covered_colour().a == 0);
    e.add({true, {1, 0, 0.25f}});
    e.add({false, {}});
    CHECK(e.mostly_covered());
    CHECK(e.colour().r == 255);
    CHECK(e.colour().g == 0);
    CHECK(e.covered_colour().a == 128);
    CHECK(e.covered_colour().r == 128);
    e.add({false, {}});
    CHECK_FALSE(e.mostly_covered());
    CHECK(e.covered_colour().a == 85);
}

TEST_CASE("texel encoder: misses are zero, black surfaces are not, in every format without palette")
{
    Estimate miss, black;
    miss.add({false, {}});
    black.add({true, {}});
    for (const TexelFormat f : detail::AllTexels::kFormats) {
        if (f == TexelFormat::palette8) continue;
        uint8_t row[6] = {};
        encode_texel(f, {}, miss, row, 0);
        encode_texel(f, {}, black, row, 1);
        const uint32_t size = detail::format::bytes_per_texel(f);
        int sum0 = 0, sum1 = 0;
        for (uint32_t k = 0; k < size; ++k) {
            sum0 += row[k];
            sum1 += row[size + k];
        }
        CHECK(sum0 == 0);
        CHECK(sum1 != 0);
    }
}

}  // namespace lumi::baker
