// SPDX-License-Identifier: MIT
// Sums of weighted texels for the span renderer: 32-bit sums, one pass over a row of taps and one over rows.
//
// TexelSum<Texel, kCoverage> has a `Row` with add(texel pointer, weight) for the taps of one origin, and itself
// add(row, weight) for the origins; `store<Pixel>(background, pixel)` blends and writes the pixel. Without kCoverage
// (over black) nothing is spent on it. How it takes them:
//   kRowBits, kTapBits  weights of the origins and of a row's taps sum to 2 to these powers
//   kUpperHalves        an origin's weight lies in the upper half of a word, and the lower one is ignored
//   kLowerHalves        a tap's weight lies in the lower half of a word, and the upper one is ignored
//   kBefore             a texel is given by the address so many bytes before it
#pragma once

#include "lumi/chord/detail/halves.h"
#include "lumi/chord/texel.h"
#include "lumi/pixel.h"

namespace lumi::detail
{

// A row's weight as Sum::add takes it: in the upper half of a word, or by itself.
template <class Sum>
constexpr uint32_t row_weight(uint32_t weight)
{
    return Sum::kUpperHalves ? weight << 16 : weight;
}

// Packs a colour as pack_rgb565 does, from Q14 below 2^22, rounded once: round(31·c/255) by 249/2048, round(63·c/255)
// by 253/1024. With DSP the upper bits of the result are not zero.
#ifdef __ARM_FEATURE_DSP
inline uint32_t packed_rgb565_q14(uint32_t r, uint32_t g, uint32_t b)
{
    uint32_t packed;
    // These are upper words of products by 2^18: each channel from bit 11 on.
    asm("smmla %[r], %[r], %[five], %[half]\n\t"
        "smmla %[g], %[g], %[six], %[half]\n\t"
        "smmla %[b], %[b], %[five], %[half]\n\t"
        "lsr %[g], %[g], #11\n\t"
        "lsr %[b], %[b], #11\n\t"
        "bfi %[r], %[g], #5, #6\n\t"
        "bfi %[r], %[b], #0, #5"
        : [r] "=&r"(packed), [g] "+r"(g), [b] "+r"(b)
        : "0"(r), [five] "r"(249u << 18), [six] "r"(2 * 253u << 18), [half] "r"(1016u));
    return packed;
}
#else
inline uint32_t packed_rgb565_q14(uint32_t r, uint32_t g, uint32_t b)
{
    const uint32_t half = settled(127u);
    const auto five = [&](uint32_t v) { return (half + (v * settled(249u) >> 17)) >> 8; };
    const uint32_t six = (half + (g * settled(253u) >> 16)) >> 8;
    return five(r) << 11 | six << 5 | five(b);
}
#endif

// Two channels at a time, (r, b) and (g, a) in the halves of a word, 7 bits of weight above 8 of colour: half the
// multiplications and half the registers of one at a time. Halves::load reads a texel so.
struct SpanHalves {
    uint32_t rb, ga;
};

// Holds a row's texels: (r, b) and (g, a) in Q7, below 2^15 in each half.
template <class Load, bool kCoverage, bool kByWords>
struct HalvesRow {
    uint32_t rb = 0, ga = 0;

    void add(const Field& field, const uint8_t* texel, uint32_t weight)
    {
        const SpanHalves c = Load::template halves<kCoverage>(field, texel);
        rb += c.rb * weight;
        ga += c.ga * weight;
    }
    SpanHalves sum() const { return {rb, ga}; }
};

// Sums words v as they are, modulo 2^32, and their odd bytes o: v·w - 256·(o·w) is the sum of the even bytes, as
// v = e + 256·o. That spares an instruction a texel.
template <class Load, bool kCoverage>
struct HalvesRow<Load, kCoverage, true> {
    uint32_t all = 0, odd = 0;

    void add(const Field& field, const uint8_t* texel, uint32_t weight)
    {
        const uint32_t v = Load::word(field, texel);
        all += v * weight;
        odd += odd_bytes(v) * weight;
    }
    SpanHalves sum() const
    {
        const uint32_t even = all - (odd << 8);
        return Load::kGreenIsHigh ? SpanHalves{odd, even} : SpanHalves{even, odd};
    }
};

template <class Load, bool kCoverage>
struct TexelSumHalves {
    static constexpr int kRowBits = 7;
    static constexpr int kTapBits = 7;
    static constexpr bool kUpperHalves = kHasHalfProducts;
    static constexpr bool kLowerHalves = false;
    static constexpr int kBefore = Load::kBefore;

    using Row = HalvesRow<Load, kCoverage, kHasHalfProducts && Load::kIsWord && !kCoverage>;
    uint32_t r = 0, g = 0, b = 0, a = 0;  // Q14

    void add(const Row& texels, uint32_t weight)
    {
        const SpanHalves row = texels.sum();
        r = add_product_low(row.rb, weight, r);
        b = add_product_high(row.rb, weight, b);
        if (Load::kGreenIsHigh)
            g = add_product_high(row.ga, weight, g);
        else
            g = kCoverage || kHasHalfProducts ? add_product_low(row.ga, weight, g) : g + row.ga * weight;
        if (kCoverage)
            a = Load::kGreenIsHigh ? add_product_low(row.ga, weight, a) : add_product_high(row.ga, weight, a);
    }

    Rgb8 over(const Rgb8& under) const
    {
        if (!kCoverage) return {rounded(r), rounded(g), rounded(b)};
        return detail::over({rounded(r), rounded(g), rounded(b), rounded(a)}, under);
    }

    template <class Pixel, class Background>
    void store(const Background& background, uint8_t* pixel) const
    {
        if constexpr (!kCoverage && kPacks565<Pixel>)
            Pixel::store_packed(pixel, static_cast<uint16_t>(packed_rgb565_q14(r, g, b)));
        else
            Pixel::store(pixel, over(background.template under<Pixel>(pixel)));
    }

private:
    static uint8_t rounded(uint32_t q14) { return static_cast<uint8_t>((q14 + (1u << 13)) >> 14); }
};

struct LoadRgb888 {
#ifdef __ARM_FEATURE_UNALIGNED
    // One word, and with it the byte before the texel: a field's texels never begin it. That byte's products stay
    // below the green ones, and nothing reads them. Flash and RAM bear unaligned words; memory of Armv7-M's Device type
    // does not.
    static constexpr bool kGreenIsHigh = true;
    static constexpr int kBefore = 1;
    static constexpr bool kIsWord = true;

    LUMI_ALWAYS_INLINE static uint32_t word(const Field&, const uint8_t* texel)
    {
        uint32_t v;
        __builtin_memcpy(&v, texel, sizeof(v));
        return v;
    }
    template <bool kCoverage>
    LUMI_ALWAYS_INLINE static SpanHalves halves(const Field& field, const uint8_t* texel)
    {
        const uint32_t v = word(field, texel);
        if (!kCoverage) return {odd_bytes(v), even_bytes(v)};
        return {odd_bytes(v), (v & 0x00FF0000u) | (v >> 8 != 0 ? 255u : 0)};
    }
#else
    static constexpr bool kGreenIsHigh = false;
    static constexpr int kBefore = 0;
    static constexpr bool kIsWord = false;

    template <bool kCoverage>
    static SpanHalves halves(const Field&, const uint8_t* texel)
    {
        const uint32_t r = texel[0];
        const uint32_t g = texel[1];
        const uint32_t b = texel[2];
        return {r | b << 16, kCoverage && (r | g | b) != 0 ? g | 255u << 16 : g};
    }
#endif
};

struct LoadPalette8 {
    static constexpr bool kGreenIsHigh = false;
    static constexpr int kBefore = 0;
    static constexpr bool kIsWord = true;

    LUMI_ALWAYS_INLINE static uint32_t word(const Field& field, const uint8_t* texel)
    {
        return load_aligned<uint32_t>(field.palette + 4u * *texel);
    }
    template <bool kCoverage>
    static SpanHalves halves(const Field& field, const uint8_t* texel)
    {
        const uint32_t entry = word(field, texel);
        if (!kCoverage && !kHasHalfProducts) return {even_bytes(entry), (entry >> 8) & 0xFF};
        return {even_bytes(entry), odd_bytes(entry)};
    }
};

// Any format of whole bytes; one with a faster way has a TexelSum of its own below.
template <class Texel>
struct LoadAny {
    static constexpr bool kGreenIsHigh = false;
    static constexpr int kBefore = 0;
    static constexpr bool kIsWord = false;

    template <bool kCoverage>
    static SpanHalves halves(const Field& field, const uint8_t* texel)
    {
        const Rgba8 c = Texel::load(field, texel, 0);
        const uint32_t r = c.r, g = c.g, b = c.b, a = c.a;
        return {r | b << 16, kCoverage ? g | a << 16 : g};
    }
};

template <class Texel, bool kCoverage>
struct TexelSum : TexelSumHalves<LoadAny<Texel>, kCoverage> {
};

template <bool kCoverage>
struct TexelSum<TexelRgb888, kCoverage> : TexelSumHalves<LoadRgb888, kCoverage> {
};

template <bool kCoverage>
struct TexelSum<TexelPalette8, kCoverage> : TexelSumHalves<LoadPalette8, kCoverage> {
};

// One channel: weights of 12 bits on both sides fill 32 bits, 255·2^24.
template <bool kCoverage>
struct TexelSum<TexelLuma8, kCoverage> {
    static constexpr int kRowBits = 12;
    static constexpr int kTapBits = 12;
    static constexpr bool kUpperHalves = false;
    static constexpr bool kLowerHalves = kHasHalfProducts && !kCoverage;
    static constexpr int kBefore = 0;

    struct Row {
        uint32_t y = 0, a = 0;

        void add(const Field&, const uint8_t* texel, uint32_t weight)
        {
            const uint32_t v = *texel;
            y = add_product16(v, weight, y);
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
        const auto over = [&](uint8_t under) {
            const uint32_t t = kCoverage ? (1u << 24) - a : 0;
            return static_cast<uint8_t>((y + t * under + settled(1u << 23)) >> 24);
        };
        if (!kCoverage) return Pixel::store_grey(pixel, over(0));
        const Rgb8 under = background.template under<Pixel>(pixel);
        Pixel::store(pixel, {over(under.r), over(under.g), over(under.b)});
    }
};

// Three channels in one word: blue (5 bits) at bit 0, red (5) at bit 11 and green (6) at bit 21 leave room for 5 bits
// of weight above each: 31·32 < 2^10, 63·32 < 2^11.
template <bool kCoverage>
struct TexelSum<TexelRgb565, kCoverage> {
    static constexpr int kRowBits = 8;
    static constexpr int kTapBits = 5;
    static constexpr bool kUpperHalves = false;
    static constexpr bool kLowerHalves = false;
    static constexpr int kBefore = 0;
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
        return {blended<16>((r * 16846u) >> 8, t, under.r), blended<16>((g * 8290u) >> 8, t, under.g),
                blended<16>((b * 16846u) >> 8, t, under.b)};
    }

    template <class Pixel, class Background>
    void store(const Background& background, uint8_t* pixel) const
    {
        if constexpr (!kCoverage && kPacks565<Pixel>) {
            const auto whole = [](uint32_t q13) { return (q13 + settled(4096u)) >> 13; };
            Pixel::store_packed(pixel, static_cast<uint16_t>(whole(r) << 11 | whole(g) << 5 | whole(b)));
        } else {
            Pixel::store(pixel, over(background.template under<Pixel>(pixel)));
        }
    }
};

}  // namespace lumi::detail
