// SPDX-License-Identifier: MIT
// Texel formats: how one stored ray becomes colour and coverage.
//
// A texel policy has `kFormat`, `kName`, and `load(field, row, j)`; row is Field::row(i), not null, and j < N. Writers
// call `store(texel, colour)`: the bytes of a ray that hits; with `kIndexed` a texel is an index into the palette
// instead. A new format is a policy here, in AllTexels, and a number in field_format.h (docs/log/chord.md). RGB888,
// RGB565 and luma8 keep one value (all bits zero) for "the ray misses the scene"; encoders move true black to the
// nearest other value, so a black object stays visible. A palette entry carries its coverage.
#pragma once
#pragma GCC system_header

#include "lumi/chord/field.h"
#include "lumi/color.h"

namespace lumi
{

struct TexelRgb888 {
    static constexpr TexelFormat kFormat = TexelFormat::rgb888;
    static constexpr const char* kName = "rgb888";
    static constexpr bool kIndexed = false;
    static constexpr Rgb8 kDarkest = {0, 0, 1};

    static detail::Rgba8 load(const Field&, const uint8_t* row, uint32_t j)
    {
        const uint8_t* texel = row + 3 * j;
        const bool hit = (texel[0] | texel[1] | texel[2]) != 0;
        return {texel[0], texel[1], texel[2], static_cast<uint8_t>(hit ? 255 : 0)};
    }
    static constexpr Rgb8 encode(const Rgb8& c) { return (c.r | c.g | c.b) == 0 ? kDarkest : c; }
    static void store(uint8_t* texel, const Rgb8& c)
    {
        const Rgb8 v = encode(c);
        texel[0] = v.r;
        texel[1] = v.g;
        texel[2] = v.b;
    }
};

struct TexelRgb565 {
    static constexpr TexelFormat kFormat = TexelFormat::rgb565;
    static constexpr const char* kName = "rgb565";
    static constexpr bool kIndexed = false;
    static constexpr uint16_t kDarkest = 1;

    static detail::Rgba8 load(const Field&, const uint8_t* row, uint32_t j)
    {
        const uint16_t v = static_cast<uint16_t>(row[2 * j] | row[2 * j + 1] << 8);
        const Rgb8 c = detail::unpack_rgb565(v);
        return {c.r, c.g, c.b, static_cast<uint8_t>(v != 0 ? 255 : 0)};
    }
    static constexpr uint16_t encode(const Rgb8& c)
    {
        const uint16_t v = detail::pack_rgb565(c);
        return v == 0 ? kDarkest : v;
    }
    static void store(uint8_t* texel, const Rgb8& c)
    {
        const uint16_t v = encode(c);
        texel[0] = static_cast<uint8_t>(v & 0xFF);
        texel[1] = static_cast<uint8_t>(v >> 8);
    }
};

struct TexelPalette8 {
    static constexpr TexelFormat kFormat = TexelFormat::palette8;
    static constexpr const char* kName = "palette8";
    static constexpr bool kIndexed = true;

    static detail::Rgba8 load(const Field& field, const uint8_t* row, uint32_t j)
    {
        const uint8_t* entry = field.palette + 4u * row[j];
        return {entry[0], entry[1], entry[2], entry[3]};
    }
};

struct TexelLuma8 {
    static constexpr TexelFormat kFormat = TexelFormat::luma8;
    static constexpr const char* kName = "luma8";
    static constexpr bool kIndexed = false;
    static constexpr uint8_t kDarkest = 1;

    static detail::Rgba8 load(const Field&, const uint8_t* row, uint32_t j)
    {
        const uint8_t v = row[j];
        return {v, v, v, static_cast<uint8_t>(v != 0 ? 255 : 0)};
    }
    static constexpr uint8_t encode(const Rgb8& c)
    {
        const uint8_t v = detail::luma(c);
        return v == 0 ? kDarkest : v;
    }
    static void store(uint8_t* texel, const Rgb8& c) { *texel = encode(c); }
};

}  // namespace lumi

namespace lumi::detail
{

template <class... Texel>
struct TexelList {
    static constexpr TexelFormat kFormats[] = {Texel::kFormat...};
    static constexpr const char* kNames[] = {Texel::kName...};
};

// Lists all formats in the order of their numbers. The build reads this line, too (core/cmake/texels.cmake).
using AllTexels = TexelList<TexelRgb888, TexelRgb565, TexelPalette8, TexelLuma8>;

// Calls use(policy) for a format, one that open_field lets pass. Links what `use` needs for every format.
template <class Use, class First, class... Rest>
auto with_texel(TexelFormat format, const Use& use, TexelList<First, Rest...>)
{
    if constexpr (sizeof...(Rest) > 0) {
        if (format != First::kFormat) return with_texel(format, use, TexelList<Rest...>());
    }
    return use(First());
}

template <class Use>
auto with_texel(TexelFormat format, const Use& use)
{
    return with_texel(format, use, AllTexels());
}

// "rgb888"; "unknown" for a number that is none.
constexpr const char* texel_name(TexelFormat format)
{
    return static_cast<uint32_t>(format) < format::kTexelFormats ? AllTexels::kNames[static_cast<uint32_t>(format)]
                                                                 : "unknown";
}

constexpr bool texels_are_in_order()
{
    uint32_t k = 0;
    for (const TexelFormat format : AllTexels::kFormats)
        if (static_cast<uint32_t>(format) != k++) return false;
    return k == format::kTexelFormats;
}
static_assert(texels_are_in_order(), "AllTexels and TexelFormat have the same order");

}  // namespace lumi::detail
