// SPDX-License-Identifier: MIT
// Small field files made from the byte layout alone, independent of the baker.
#pragma once

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "lumi/chord/format.h"
#include "lumi/detail/crc32.h"

namespace lumi::tools::test
{

class ByteWriter
{
public:
    void u16(uint32_t value) { little_endian(value, 2); }
    void u32(uint32_t value) { little_endian(value, 4); }
    void f32(float value)
    {
        uint32_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        u32(bits);
    }
    void u8(uint32_t value) { little_endian(value, 1); }
    void append(const std::string& bytes) { bytes_ += bytes; }
    void pad_to(size_t multiple) { bytes_.resize((bytes_.size() + multiple - 1) / multiple * multiple, '\0'); }
    const std::string& bytes() const { return bytes_; }

private:
    void little_endian(uint32_t value, int count)
    {
        for (int i = 0; i < count; ++i) bytes_ += static_cast<char>(static_cast<uint8_t>(value >> (8 * i)));
    }

    std::string bytes_;
};

inline uint32_t crc_of(const std::string& bytes)
{
    return detail::crc32(0, reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
}

struct TestField {
    uint32_t origins = 40, directions = 60, used_origins = 40;
    TexelFormat texel = TexelFormat::rgb888;
};

inline std::string layout_bytes(const TestField& field)
{
    ByteWriter layout;
    layout.u32(field.origins);
    layout.u32(field.directions);
    layout.u32(field.used_origins);
    layout.u32(detail::format::padded_row_stride(field.directions, field.texel));
    layout.u8(static_cast<uint32_t>(field.texel));
    layout.u8(static_cast<uint32_t>(ColourSpace::srgb));
    layout.u16(0);
    for (const float centre : {1.5f, -2.0f, 0.25f}) layout.f32(centre);
    layout.f32(3.5f);
    return layout.bytes();
}

// Row i is one colour: bytes that repeat with i, none of them zero, so that every ray hits.
inline std::string texel_bytes(const TestField& field)
{
    const uint32_t stride = detail::format::padded_row_stride(field.directions, field.texel);
    std::string texels;
    for (uint32_t i = 0; i < field.used_origins; ++i)
        texels += std::string(stride, static_cast<char>(static_cast<uint8_t>(1 + i * 7 % 250)));
    return texels;
}

// Entry e is opaque grey of value e.
inline std::string palette_bytes()
{
    ByteWriter palette;
    for (uint32_t e = 0; e < detail::format::kPaletteEntries; ++e)
        for (const uint32_t value : {e, e, e, 255u}) palette.u8(value);
    return palette.bytes();
}

struct TestSection {
    uint32_t type;
    std::string bytes;
    bool is_required = true;
};

// A file of these sections.
inline std::string file_bytes(const std::vector<TestSection>& sections)
{
    const auto aligned = [](size_t size) {
        return (size + detail::format::kSectionAlignment - 1) / detail::format::kSectionAlignment *
               detail::format::kSectionAlignment;
    };
    ByteWriter table, body;
    const size_t body_at = aligned(detail::format::kHeaderBytes + sections.size() * detail::format::kEntryBytes);
    for (const TestSection& section : sections) {
        body.pad_to(detail::format::kSectionAlignment);
        table.u32(section.type);
        table.u32(section.is_required ? detail::format::kRequired : 0);
        table.u32(static_cast<uint32_t>(body_at + body.bytes().size()));
        table.u32(static_cast<uint32_t>(section.bytes.size()));
        table.u32(crc_of(section.bytes));
        body.append(section.bytes);
    }

    ByteWriter file;
    file.append(std::string(reinterpret_cast<const char*>(detail::format::kMagic), sizeof detail::format::kMagic));
    file.u16(detail::format::kVersion);
    file.u16(detail::format::kHeaderBytes);
    file.u32(static_cast<uint32_t>(body_at + body.bytes().size()));
    file.u16(static_cast<uint32_t>(sections.size()));
    file.u16(detail::format::kEntryBytes);
    file.u32(0);
    file.u32(crc_of(table.bytes()));
    file.u32(crc_of(file.bytes()));
    file.append(table.bytes());
    file.pad_to(detail::format::kSectionAlignment);
    file.append(body.bytes());
    return file.bytes();
}

inline std::string field_bytes(const TestField& field)
{
    std::vector<TestSection> sections = {{detail::format::kLayoutSection, layout_bytes(field)}};
    if (field.texel == TexelFormat::palette8) sections.push_back({detail::format::kPaletteSection, palette_bytes()});
    sections.push_back({detail::format::kTexelSection, texel_bytes(field)});
    return file_bytes(sections);
}

// The container of a guided field, which no reader opens any more.
inline std::string guided_bytes()
{
    return file_bytes({{detail::format::four_cc('G', 'U', 'I', 'D'), std::string(44, '\1')}});
}

}  // namespace lumi::tools::test
