// SPDX-License-Identifier: MIT
// Output formats of a display: policies with `kBytes`, `store(pointer, colour)` and `load(pointer)`. Any alignment.
#pragma once

#include <cstdint>

#include "lumi/color.h"

namespace lumi
{

// 16 bits, low byte first: a Cortex-M's own order.
struct PixelRgb565 {
    static constexpr uint32_t kBytes = 2;
    static void store(uint8_t* p, const Rgb8& c)
    {
        const uint16_t v = pack_rgb565(c);
        p[0] = static_cast<uint8_t>(v);
        p[1] = static_cast<uint8_t>(v >> 8);
    }
    static Rgb8 load(const uint8_t* p) { return unpack_rgb565(static_cast<uint16_t>(p[0] | p[1] << 8)); }
};

// 16 bits, high byte first: the order in which SPI panels take them.
struct PixelRgb565Swapped {
    static constexpr uint32_t kBytes = 2;
    static void store(uint8_t* p, const Rgb8& c)
    {
        const uint16_t v = pack_rgb565(c);
        p[0] = static_cast<uint8_t>(v >> 8);
        p[1] = static_cast<uint8_t>(v);
    }
    static Rgb8 load(const uint8_t* p) { return unpack_rgb565(static_cast<uint16_t>(p[1] | p[0] << 8)); }
};

// 3 bytes: red, green, blue.
struct PixelRgb888 {
    static constexpr uint32_t kBytes = 3;
    static void store(uint8_t* p, const Rgb8& c)
    {
        p[0] = c.r;
        p[1] = c.g;
        p[2] = c.b;
    }
    static Rgb8 load(const uint8_t* p) { return {p[0], p[1], p[2]}; }
};

// 1 byte of luma.
struct PixelGrey8 {
    static constexpr uint32_t kBytes = 1;
    static void store(uint8_t* p, const Rgb8& c) { p[0] = luma(c); }
    static Rgb8 load(const uint8_t* p) { return {p[0], p[0], p[0]}; }
};

}  // namespace lumi
