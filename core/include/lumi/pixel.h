// SPDX-License-Identifier: MIT
// Output formats of a display: policies with `kBytes`, `store(pointer, colour)`, `store_grey(pointer, value)` (the same
// for equal channels) and `load(pointer)`. Pixels of 16 and 32 bits lie at multiples of their size. Those that hold
// coverage also have `store_covered(pointer, colour, coverage)`, see OverNothing. A new format needs no more: the
// traits at the end of this file only make some formats faster. Packed greys: pack.h.
#pragma once
#pragma GCC system_header

#include <stdint.h>

#include "lumi/color.h"
#include "lumi/detail/aligned_words.h"

namespace lumi
{

// Stores 16 bits, low byte first: a Cortex-M's own order.
struct PixelRgb565 {
    static constexpr uint32_t kBytes = 2;
    static void store(uint8_t* p, const Rgb8& c) { store_packed(p, detail::pack_rgb565(c)); }
    static void store_packed(uint8_t* p, uint16_t v) { detail::store_aligned<uint16_t>(p, v); }
    static void store_grey(uint8_t* p, uint8_t v) { detail::store_aligned<uint16_t>(p, detail::kGreyTable.rgb565[v]); }
    static uint16_t load_packed(const uint8_t* p) { return detail::load_aligned<uint16_t>(p); }
    static Rgb8 load(const uint8_t* p) { return detail::unpack_rgb565(load_packed(p)); }
};

// 16 bits, high byte first: the order in which SPI panels take them.
struct PixelRgb565Swapped {
    static constexpr uint32_t kBytes = 2;
    static void store(uint8_t* p, const Rgb8& c) { store_packed(p, detail::pack_rgb565(c)); }
    static void store_packed(uint8_t* p, uint16_t v) { detail::store_aligned<uint16_t>(p, __builtin_bswap16(v)); }
    static void store_grey(uint8_t* p, uint8_t v) { store_packed(p, detail::kGreyTable.rgb565[v]); }
    static uint16_t load_packed(const uint8_t* p) { return __builtin_bswap16(detail::load_aligned<uint16_t>(p)); }
    static Rgb8 load(const uint8_t* p) { return detail::unpack_rgb565(load_packed(p)); }
};

// 16 bits, low byte first: red in the low bits, as the Game Boy Advance has it. The top bit is 0.
struct PixelBgr555 {
    static constexpr uint32_t kBytes = 2;
    static void store(uint8_t* p, const Rgb8& c) { store_packed(p, detail::pack_bgr555(c)); }
    static void store_packed(uint8_t* p, uint16_t v) { detail::store_aligned<uint16_t>(p, v); }
    static void store_grey(uint8_t* p, uint8_t v) { store(p, {v, v, v}); }
    static Rgb8 load(const uint8_t* p) { return detail::unpack_bgr555(detail::load_aligned<uint16_t>(p)); }
};

// Stores 3 bytes: red, green, blue.
struct PixelRgb888 {
    static constexpr uint32_t kBytes = 3;
    static void store(uint8_t* p, const Rgb8& c)
    {
        p[0] = c.r;
        p[1] = c.g;
        p[2] = c.b;
    }
    static void store_grey(uint8_t* p, uint8_t v) { store(p, {v, v, v}); }
    static Rgb8 load(const uint8_t* p) { return {p[0], p[1], p[2]}; }
};

// 3 bytes: blue, green, red, as LTDC, DMA2D and LVGL keep 24 bits.
struct PixelBgr888 {
    static constexpr uint32_t kBytes = 3;
    static void store(uint8_t* p, const Rgb8& c) { PixelRgb888::store(p, {c.b, c.g, c.r}); }
    static void store_grey(uint8_t* p, uint8_t v) { PixelRgb888::store(p, {v, v, v}); }
    static Rgb8 load(const uint8_t* p) { return {p[2], p[1], p[0]}; }
};

// Stores 1 byte of luma.
struct PixelGrey8 {
    static constexpr uint32_t kBytes = 1;
    static void store(uint8_t* p, const Rgb8& c) { p[0] = detail::luma(c); }
    static void store_grey(uint8_t* p, uint8_t v) { p[0] = v; }
    static Rgb8 load(const uint8_t* p) { return {p[0], p[0], p[0]}; }
};

// Stores 4 bytes: blue, green, red, coverage. A 32-bit word, low byte first, has coverage on top. Colours are not
// premultiplied.
struct PixelArgb8888 {
    static constexpr uint32_t kBytes = 4;
    static void store(uint8_t* p, const Rgb8& c) { store_covered(p, c, 255); }
    static void store_covered(uint8_t* p, const Rgb8& c, uint8_t coverage)
    {
        const uint32_t v = static_cast<uint32_t>(coverage) << 24 | static_cast<uint32_t>(c.r) << 16 |
                           static_cast<uint32_t>(c.g) << 8 | c.b;
        detail::store_aligned<uint32_t>(p, v);
    }
    static void store_grey(uint8_t* p, uint8_t v) { store(p, {v, v, v}); }
    static Rgb8 load(const uint8_t* p) { return {p[2], p[1], p[0]}; }
};

// Stores 1 byte of coverage alone, without colour.
struct PixelA8 {
    static constexpr uint32_t kBytes = 1;
    static void store(uint8_t* p, const Rgb8&) { p[0] = 255; }
    static void store_covered(uint8_t* p, const Rgb8&, uint8_t coverage) { p[0] = coverage; }
    static void store_grey(uint8_t* p, uint8_t) { p[0] = 255; }
    static Rgb8 load(const uint8_t* p) { return {p[0], p[0], p[0]}; }
};

}  // namespace lumi

namespace lumi::detail
{

// Tells formats that also have store_packed(pointer, red, green and blue in 5, 6 and 5 bits) and load_packed(pointer).
template <class Pixel>
inline constexpr bool kPacks565 = false;
template <>
inline constexpr bool kPacks565<PixelRgb565> = true;
template <>
inline constexpr bool kPacks565<PixelRgb565Swapped> = true;

// Tells formats that also have store_packed(pointer, blue, green and red in 5 bits each).
template <class Pixel>
inline constexpr bool kPacks555 = false;
template <>
inline constexpr bool kPacks555<PixelBgr555> = true;

// Tells formats that have store_covered().
template <class Pixel>
inline constexpr bool kHoldsCoverage = false;
template <>
inline constexpr bool kHoldsCoverage<PixelArgb8888> = true;
template <>
inline constexpr bool kHoldsCoverage<PixelA8> = true;

}  // namespace lumi::detail
