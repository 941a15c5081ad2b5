// SPDX-License-Identifier: MIT
// Nine taps against sums of one product a tap and channel, and colours packed by hand against pack_rgb565.
#include <catch2/catch.hpp>
#include <random>

#include "lumi/chord/detail/both_sides.h"
#include "lumi/chord/detail/both_sides_steps.h"

using namespace lumi;
using namespace lumi::detail;

namespace
{

constexpr int kPixels = 2000;
constexpr uint32_t kTexels = 300;

// Random numbers.
class Draw
{
public:
    uint32_t below(uint32_t end) { return static_cast<uint32_t>(random_()) % end; }
    int32_t signed_below(int32_t end)
    {
        return static_cast<int32_t>(below(static_cast<uint32_t>(2 * end - 1))) - end + 1;
    }

    // Three weights in halves of words that sum to one in each half.
    template <class Sum>
    void weights(PixelTaps& taps)
    {
        uint32_t rest = BothSidesBits<Sum::kRowBits, Sum::kTapBits>::kOnes;
        for (int k = 0; k < 3; ++k) {
            const uint32_t w = k == 2 ? rest : below((rest >> 16) + 1) << 16 | below((rest & 0xFFFF) + 1);
            rest -= w;
            taps.row_weight[k] = Sum::kUpperHalves ? w : w >> 16;
            taps.weight[k] = Sum::kLowerHalves ? w : w & 0xFFFF;
        }
    }

private:
    std::minstd_rand random_{1};
};

// One product a tap and channel.
struct PlainSum {
    uint32_t r = 0, g = 0, b = 0, a = 0;

    void add(const Rgba8& c, uint32_t weight)
    {
        r += c.r * weight;
        g += c.g * weight;
        b += c.b * weight;
        a += c.a * weight;
    }
};

template <class Texel, bool kCoverage>
int wrong_sums(bool is_white)
{
    using Sum = TexelSum<Texel, kCoverage>;
    constexpr uint32_t kTexelBytes = format::bytes_per_texel(Texel::kFormat);
    constexpr int32_t kBytes = static_cast<int32_t>(kTexelBytes);
    Draw draw;
    static uint8_t texels[kTexels * kTexelBytes + 4];
    alignas(4) static uint8_t palette[1024];
    for (uint8_t& v : texels) v = static_cast<uint8_t>(is_white ? 255 : draw.below(256));
    for (uint8_t& v : palette) v = static_cast<uint8_t>(is_white ? 255 : draw.below(256));
    Field field{};
    field.palette = palette;
    int wrong = 0;
    for (int k = 0; k < kPixels; ++k) {
        PixelTaps taps;
        for (const uint8_t*& row : taps.row)
            row = texels + kBytes * static_cast<int32_t>(100 + draw.below(100)) + kBytes - Sum::kBefore;
        for (int32_t& offset : taps.offset) offset = kBytes * draw.signed_below(100);
        draw.weights<Sum>(taps);
        PlainSum expected;
        for (int m = 0; m < 3; ++m) {
            const uint32_t row_weight = Sum::kUpperHalves ? taps.row_weight[m] >> 16 : taps.row_weight[m];
            for (int t = 0; t < 3; ++t) {
                const uint8_t* const texel = taps.row[m] + (t == 0 ? 0 : taps.offset[t - 1]) + Sum::kBefore;
                expected.add(Texel::load(field, texel, 0), row_weight * taps.weight[t]);
            }
        }
        const Sum sum = sum_of<Sum>(field, taps);
        wrong += sum.r != expected.r || sum.g != expected.g || sum.b != expected.b;
        wrong += kCoverage && sum.a != expected.a;
    }
    return wrong;
}

}  // namespace

TEST_CASE("nine taps sum to what each channel of each tap adds", "[span]")
{
    for (const bool is_white : {false, true}) {
        CHECK(wrong_sums<TexelPalette8, false>(is_white) == 0);
        CHECK(wrong_sums<TexelPalette8, true>(is_white) == 0);
        CHECK(wrong_sums<TexelRgb888, false>(is_white) == 0);
        CHECK(wrong_sums<TexelRgb888, true>(is_white) == 0);
    }
}

TEST_CASE("whole colours of a sum are packed as pack_rgb565 packs them", "[span]")
{
    for (uint32_t v = 0; v < 256; ++v) {
        const uint8_t c = static_cast<uint8_t>(v);
        const uint8_t other = static_cast<uint8_t>(255 - v);
        CHECK(static_cast<uint16_t>(packed_rgb565_q14(v << 14, (255 - v) << 14, v << 14)) ==
              pack_rgb565({c, other, c}));
        CHECK(static_cast<uint16_t>(packed_rgb565_q14((255 - v) << 14, v << 14, 0)) == pack_rgb565({other, c, 0}));
    }
}
