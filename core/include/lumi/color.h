// SPDX-License-Identifier: MIT
// Colours have 8 bits a channel, sRGB-encoded. Texels and displays share their packings.
#pragma once
#pragma GCC system_header

#include <stdint.h>

#include "lumi/detail/compiler.h"

namespace lumi
{

struct Rgb8 {
    uint8_t r, g, b;
};

// How much of a state's light shows (surface/states.h): 0 to kFullWeight; more counts as that.
inline constexpr uint32_t kFullWeight = 4096;
struct StateWeight {
    uint16_t r_q12, g_q12, b_q12;
};

}  // namespace lumi

namespace lumi::detail
{

// Premultiplied colour with coverage: a = 0 is a ray that misses the scene, r, g, b <= a.
struct Rgba8 {
    uint8_t r, g, b, a;
};

// Lays a premultiplied colour c over a background u: c + (1 - a)·u. (257·x + 2^15)/2^16 is x/255 rounded to nearest,
// but for 24 of all 65,536 products.
constexpr Rgb8 over(const Rgba8& c, const Rgb8& under)
{
    const uint32_t transparency = 255u - c.a;
    const auto blend = [&](uint8_t v, uint8_t u) {
        return static_cast<uint8_t>(v + (transparency * u * 257u + 32768u) / 65536u);
    };
    return {blend(c.r, under.r), blend(c.g, under.g), blend(c.b, under.b)};
}

// Blends one channel of a weighted sum: c + (1 - a)·u with c and 1 - a times 2^kBits, to which the weights sum.
template <int kBits>
constexpr uint8_t blended(uint32_t sum, uint32_t transparency, uint8_t under)
{
    return static_cast<uint8_t>((sum + transparency * under + (1u << (kBits - 1))) >> kBits);
}

// Returns the luma of encoded values, ITU-R BT.709 weights in 1/256; the weights sum to 256, so grey stays grey.
constexpr uint8_t luma(const Rgb8& c)
{
    return static_cast<uint8_t>((54u * c.r + 183u * c.g + 19u * c.b + 128u) >> 8);
}

// Packs 5-6-5 with red in the high bits: round(31·c/255) by 249/2048, round(63·c/255) by 253/1024, so that
// unpack(pack(unpack(v))) = unpack(v). Unpacked, v has its upper bits once more below: 255·v/31 or 255·v/63 within 1.
constexpr uint16_t pack_rgb565(const Rgb8& c)
{
    const uint32_t r = (c.r * 249u + 1014u) >> 11;
    const uint32_t g = (c.g * 253u + 505u) >> 10;
    const uint32_t b = (c.b * 249u + 1014u) >> 11;
    return static_cast<uint16_t>(r << 11 | g << 5 | b);
}

constexpr Rgb8 unpack_rgb565(uint16_t v)
{
    const uint32_t r = v >> 11;
    const uint32_t g = (v >> 5) & 63u;
    const uint32_t b = v & 31u;
    return {static_cast<uint8_t>(r << 3 | r >> 2), static_cast<uint8_t>(g << 2 | g >> 4),
            static_cast<uint8_t>(b << 3 | b >> 2)};
}

// Packs 5-5-5 with blue in the high bits, by the same products.
constexpr uint16_t pack_bgr555(const Rgb8& c)
{
    const auto five = [](uint8_t v) { return (v * 249u + 1014u) >> 11; };
    return static_cast<uint16_t>(five(c.b) << 10 | five(c.g) << 5 | five(c.r));
}

constexpr Rgb8 unpack_bgr555(uint16_t v)
{
    const auto eight = [](uint32_t five) { return static_cast<uint8_t>(five << 3 | five >> 2); };
    return {eight(v & 31u), eight((v >> 5) & 31u), eight((v >> 10) & 31u)};
}

// Holds pack_rgb565 of every grey, where one look-up beats a dozen instructions a pixel. Linked only if used: 512
// bytes.
struct GreyTable {
    uint16_t rgb565[256];
};

constexpr GreyTable make_grey_table()
{
    GreyTable t{};
    for (uint32_t v = 0; v < 256; ++v) {
        const uint8_t c = static_cast<uint8_t>(v);
        t.rgb565[v] = pack_rgb565({c, c, c});
    }
    return t;
}

inline constexpr GreyTable kGreyTable = make_grey_table();

}  // namespace lumi::detail
