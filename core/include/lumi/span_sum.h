// SPDX-License-Identifier: MIT
// Sums of weighted texels for the span renderer: 8-bit weights, 32-bit sums, one pass over a row of taps and one over
// rows.
//
// SpanSum<Texel, kCoverage> has a `Row` with add(texel pointer, weight) for the taps of one origin, and itself add(row,
// weight) for the origins; `store<Pixel>(background, pixel)` blends and writes the pixel.
// Without kCoverage (over black) nothing is spent on it.
#pragma once

#include "lumi/texel.h"

namespace lumi
{

inline constexpr int kSpanBits = 8;  // of an origin's weight: weights of a side sum to 2^8

template <class T>
T load_aligned(const uint8_t* p)
{
    T v = 0;
    __builtin_memcpy(&v, __builtin_assume_aligned(p, sizeof(T)), sizeof(T));
    return v;
}

constexpr uint8_t blended(uint32_t sum_q16, uint32_t transparency_q16, uint8_t under)
{
    return static_cast<uint8_t>((sum_q16 + transparency_q16 * under + 0x8000u) >> 16);
}

// Two channels at a time, (r, b) and (g, a) in the halves of a word, 8 bits of weight above 8 of colour: half the
// multiplications and half the registers of one at a time. Halves::load reads a texel so.
struct SpanHalves {
    uint32_t rb, ga;
};

template <class Load, bool kCoverage>
struct SpanSumHalves {
    static constexpr int kTapBits = kSpanBits;
    static constexpr uint32_t kMask = 0x00FF00FFu;
    // Half a level for each of the two roundings down, less 1/256 so that white stays within its half.
    static constexpr uint32_t kRound = 0x00FF00FFu;

    struct Row {
        uint32_t rb = 0, ga = 0;

        void add(const Field& field, const uint8_t* texel, uint32_t weight)
        {
            const SpanHalves c = Load::template halves<kCoverage>(field, texel);
            rb += c.rb * weight;
            ga += c.ga * weight;
        }
    };
    uint32_t rb = kRound, ga = kRound;

    void add(const Row& row, uint32_t weight)
    {
        rb += ((row.rb >> 8) & kMask) * weight;
        ga += ((row.ga >> 8) & kMask) * weight;
    }

    Rgb8 over(const Rgb8& under) const
    {
        const auto high = [](uint32_t sum) { return static_cast<uint8_t>(sum >> 24); };
        const auto low = [](uint32_t sum) { return static_cast<uint8_t>(sum >> 8); };
        if (!kCoverage) return {low(rb), low(ga), high(rb)};
        const uint32_t t = 255u - high(ga);
        const auto over_one = [&](uint8_t c, uint8_t u) {
            return static_cast<uint8_t>(c + (t * u * 257u + 32768u) / 65536u);
        };
        return {over_one(low(rb), under.r), over_one(low(ga), under.g), over_one(high(rb), under.b)};
    }

    template <class Pixel, class Background>
    void store(const Background& background, uint8_t* pixel) const
    {
        Pixel::store(pixel, over(background.template under<Pixel>(pixel)));
    }
};

struct LoadRgb888 {
    template <bool kCoverage>
    static SpanHalves halves(const Field&, const uint8_t* texel)
    {
        const uint32_t r = texel[0];
        const uint32_t g = texel[1];
        const uint32_t b = texel[2];
        return {r | b << 16, kCoverage && (r | g | b) != 0 ? g | 255u << 16 : g};
    }
};

struct LoadPalette8 {
    template <bool kCoverage>
    static SpanHalves halves(const Field& field, const uint8_t* texel)
    {
        const uint32_t entry = load_aligned<uint32_t>(field.palette + 4u * *texel);
        return {entry & 0x00FF00FFu, (entry >> 8) & 0x00FF00FFu};
    }
};

template <class Texel, bool kCoverage>
struct SpanSum;

template <bool kCoverage>
struct SpanSum<TexelRgb888, kCoverage> : SpanSumHalves<LoadRgb888, kCoverage> {
};

template <bool kCoverage>
struct SpanSum<TexelPalette8, kCoverage> : SpanSumHalves<LoadPalette8, kCoverage> {
};

// One channel.
template <bool kCoverage>
struct SpanSum<TexelLuma8, kCoverage> {
    static constexpr int kTapBits = kSpanBits;
    struct Row {
        uint32_t y = 0, a = 0;

        void add(const Field&, const uint8_t* texel, uint32_t weight)
        {
            const uint32_t v = *texel;
            y += v * weight;
            if (kCoverage) a += v != 0 ? weight : 0;
        }
    };
    uint32_t y = 0, a = 0;

    void add(const Row& row, uint32_t weight)
    {
        y += row.y * weight;
        if (kCoverage) a += row.a * weight;
    }

    template <class Pixel, class Background>
    void store(const Background& background, uint8_t* pixel) const
    {
        if (!kCoverage) return Pixel::store_grey(pixel, blended(y, 0, 0));
        const Rgb8 under = background.template under<Pixel>(pixel);
        const uint32_t t = 65536u - a;
        Pixel::store(pixel, {blended(y, t, under.r), blended(y, t, under.g), blended(y, t, under.b)});
    }
};

// Three channels in one word: blue (5 bits) at bit 0, red (5) at bit 11 and green (6) at bit 21 leave room for 5 bits
// of weight above each: 31·32 < 2^10, 63·32 < 2^11.
template <bool kCoverage>
struct SpanSum<TexelRgb565, kCoverage> {
    static constexpr int kTapBits = 5;
    static constexpr uint32_t kFields = 0x07E0F81Fu;

    struct Row {
        uint32_t fields = 0, a = 0;

        void add(const Field&, const uint8_t* texel, uint32_t weight)
        {
            const uint32_t v = load_aligned<uint16_t>(texel);
            fields += ((v | v << 16) & kFields) * weight;
            if (kCoverage) a += v != 0 ? weight : 0;
        }
    };
    uint32_t r = 0, g = 0, b = 0, a = 0;  // Q13 of 5, 6 and 5 bits

    void add(const Row& row, uint32_t weight)
    {
        b += (row.fields & 0x7FFu) * weight;
        r += ((row.fields >> 11) & 0x3FFu) * weight;
        g += (row.fields >> 21) * weight;
        if (kCoverage) a += row.a * weight;
    }

    Rgb8 over(const Rgb8& under) const
    {
        // 8·255/31 and 8·255/63 in Q8: sums of 31·2^13 and 63·2^13 become 255·2^16, within 32 bits on the way.
        const uint32_t t = kCoverage ? 65536u - 8 * a : 0;
        return {blended((r * 16846u) >> 8, t, under.r), blended((g * 8290u) >> 8, t, under.g),
                blended((b * 16846u) >> 8, t, under.b)};
    }

    template <class Pixel, class Background>
    void store(const Background& background, uint8_t* pixel) const
    {
        Pixel::store(pixel, over(background.template under<Pixel>(pixel)));
    }
};

}  // namespace lumi
