// SPDX-License-Identifier: MIT
// Builds field files byte by byte for tests, valid or not: written from docs/field-format.md, not from the baker's
// writer.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "lumi/chord/format.h"
#include "lumi/detail/crc32.h"

namespace lumi::test
{

using Bytes = std::vector<uint8_t>;

inline void put16(Bytes& b, uint32_t v)
{
    b.push_back(static_cast<uint8_t>(v));
    b.push_back(static_cast<uint8_t>(v >> 8));
}

inline void put32(Bytes& b, uint32_t v)
{
    put16(b, v & 0xFFFF);
    put16(b, v >> 16);
}

inline uint32_t float_bits(float v)
{
    uint32_t bits = 0;
    std::memcpy(&bits, &v, sizeof bits);
    return bits;
}

struct TestSection {
    uint32_t type;
    uint32_t flags;
    Bytes bytes;
};

struct TestLayout {
    uint32_t origins = 6, directions = 10, used_origins = 6;
    uint32_t row_stride = 0;  // 0: the padded one
    TexelFormat texel = TexelFormat::rgb888;
    uint8_t colour_space = 0;
    float centre[3] = {1, 2, 3};
    float radius = 4;

    uint32_t stride() const
    {
        return row_stride != 0 ? row_stride : detail::format::padded_row_stride(directions, texel);
    }
};

// With all origins baked, unless `used` says fewer.
inline TestLayout layout_of(uint32_t origins, uint32_t directions, TexelFormat texel, uint32_t used = UINT32_MAX)
{
    TestLayout layout;
    layout.origins = origins;
    layout.used_origins = std::min(origins, used);
    layout.directions = directions;
    layout.texel = texel;
    return layout;
}

inline TestSection layout_section(const TestLayout& layout)
{
    Bytes b;
    put32(b, layout.origins);
    put32(b, layout.directions);
    put32(b, layout.used_origins);
    put32(b, layout.stride());
    b.push_back(static_cast<uint8_t>(layout.texel));
    b.push_back(layout.colour_space);
    put16(b, 0);
    for (const float c : layout.centre) put32(b, float_bits(c));
    put32(b, float_bits(layout.radius));
    return {detail::format::kLayoutSection, detail::format::kRequired, b};
}

// Texels from a function of (row, byte in row).
template <class Texel>
TestSection texel_section(const TestLayout& layout, Texel texel)
{
    Bytes b;
    for (uint32_t i = 0; i < layout.used_origins; ++i)
        for (uint32_t k = 0; k < layout.stride(); ++k) b.push_back(texel(i, k));
    return {detail::format::kTexelSection, detail::format::kRequired, b};
}

// A palette whose entry k is (k, k/2, 255-k) at full coverage; entry 0 is a miss.
inline TestSection palette_section()
{
    Bytes b(4, 0);
    for (uint32_t k = 1; k < detail::format::kPaletteEntries; ++k) {
        b.push_back(static_cast<uint8_t>(k));
        b.push_back(static_cast<uint8_t>(k / 2));
        b.push_back(static_cast<uint8_t>(255 - k));
        b.push_back(255);
    }
    return {detail::format::kPaletteSection, detail::format::kRequired, b};
}

inline Bytes file_of(const std::vector<TestSection>& sections)
{
    Bytes table;
    Bytes body;
    const uint32_t start =
        (detail::format::kHeaderBytes + static_cast<uint32_t>(sections.size()) * detail::format::kEntryBytes + 7) & ~7u;
    for (const TestSection& s : sections) {
        body.resize((body.size() + 7) & ~size_t{7});
        put32(table, s.type);
        put32(table, s.flags);
        put32(table, start + static_cast<uint32_t>(body.size()));
        put32(table, static_cast<uint32_t>(s.bytes.size()));
        put32(table, detail::crc32(0, s.bytes.data(), s.bytes.size()));
        body.insert(body.end(), s.bytes.begin(), s.bytes.end());
    }
    Bytes file(detail::format::kMagic, detail::format::kMagic + 8);
    put16(file, detail::format::kVersion);
    put16(file, detail::format::kHeaderBytes);
    put32(file, start + static_cast<uint32_t>(body.size()));
    put16(file, static_cast<uint32_t>(sections.size()));
    put16(file, detail::format::kEntryBytes);
    put32(file, 0);
    put32(file, detail::crc32(0, table.data(), table.size()));
    put32(file, detail::crc32(0, file.data(), file.size()));
    file.insert(file.end(), table.begin(), table.end());
    file.resize(start);
    file.insert(file.end(), body.begin(), body.end());
    return file;
}

// A field of smooth but eventful texels.
inline Bytes sample_field(const TestLayout& layout)
{
    std::vector<TestSection> sections = {layout_section(layout), texel_section(layout, [](uint32_t i, uint32_t k) {
                                             return static_cast<uint8_t>(i * 37 + k * 11 + (i * k) / 7);
                                         })};
    if (layout.texel == TexelFormat::palette8) sections.push_back(palette_section());
    return file_of(sections);
}

// Puts both CRCs of header and table right again after a change.
inline void reseal(Bytes& file)
{
    const auto put_at = [&](uint32_t at, uint32_t v) {
        for (uint32_t k = 0; k < 4; ++k) file[at + k] = static_cast<uint8_t>(v >> (8 * k));
    };
    const uint32_t count = static_cast<uint32_t>(file[16]) | static_cast<uint32_t>(file[17]) << 8;
    const size_t table_bytes = size_t{count} * detail::format::kEntryBytes;
    if (file.size() >= detail::format::kHeaderBytes + table_bytes)
        put_at(detail::format::header::kTableCrcAt,
               detail::crc32(0, file.data() + detail::format::kHeaderBytes, table_bytes));
    put_at(detail::format::header::kHeaderCrcAt, detail::crc32(0, file.data(), detail::format::header::kHeaderCrcAt));
}

}  // namespace lumi::test
