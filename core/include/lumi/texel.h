// SPDX-License-Identifier: MIT
// Texel formats: how one stored ray becomes colour and coverage.
//
// A texel policy has `kFormat` and `load(field, row, j)`; row is Field::row(i), not null, and j < N.
// RGB888, RGB565 and luma8 keep one value (all bits zero) for "the ray misses the scene"; encoders move true black to
// the nearest other value, so a black object stays visible. A palette entry carries its coverage.
#pragma once

#include "lumi/color.h"
#include "lumi/field.h"

namespace lumi
{

struct TexelRgb888 {
    static constexpr format::TexelFormat kFormat = format::TexelFormat::rgb888;
    static constexpr Rgb8 kDarkest = {0, 0, 1};

    static Rgba8 load(const Field&, const uint8_t* row, uint32_t j)
    {
        const uint8_t* texel = row + 3 * j;
        const bool hit = (texel[0] | texel[1] | texel[2]) != 0;
        return {texel[0], texel[1], texel[2], static_cast<uint8_t>(hit ? 255 : 0)};
    }
    static constexpr Rgb8 encode(const Rgb8& c) { return (c.r | c.g | c.b) == 0 ? kDarkest : c; }
};

struct TexelRgb565 {
    static constexpr format::TexelFormat kFormat = format::TexelFormat::rgb565;
    static constexpr uint16_t kDarkest = 1;

    static Rgba8 load(const Field&, const uint8_t* row, uint32_t j)
    {
        const uint16_t v = static_cast<uint16_t>(row[2 * j] | row[2 * j + 1] << 8);
        const Rgb8 c = unpack_rgb565(v);
        return {c.r, c.g, c.b, static_cast<uint8_t>(v != 0 ? 255 : 0)};
    }
    static constexpr uint16_t encode(const Rgb8& c)
    {
        const uint16_t v = pack_rgb565(c);
        return v == 0 ? kDarkest : v;
    }
};

struct TexelPalette8 {
    static constexpr format::TexelFormat kFormat = format::TexelFormat::palette8;

    static Rgba8 load(const Field& field, const uint8_t* row, uint32_t j)
    {
        const uint8_t* entry = field.palette + 4u * row[j];
        return {entry[0], entry[1], entry[2], entry[3]};
    }
};

struct TexelLuma8 {
    static constexpr format::TexelFormat kFormat = format::TexelFormat::luma8;
    static constexpr uint8_t kDarkest = 1;

    static Rgba8 load(const Field&, const uint8_t* row, uint32_t j)
    {
        const uint8_t v = row[j];
        return {v, v, v, static_cast<uint8_t>(v != 0 ? 255 : 0)};
    }
    static constexpr uint8_t encode(const Rgb8& c)
    {
        const uint8_t v = luma(c);
        return v == 0 ? kDarkest : v;
    }
};

}  // namespace lumi
