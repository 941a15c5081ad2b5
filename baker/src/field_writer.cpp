// SPDX-License-Identifier: MIT
#include "field_writer.h"

#include <cstring>

#include "lumi/crc32.h"

namespace lumi::baker
{
namespace
{

class Bytes
{
public:
    explicit Bytes(size_t size) : bytes_(size) {}

    void put8(size_t at, uint8_t v) { bytes_[at] = v; }
    void put16(size_t at, uint16_t v)
    {
        put8(at, static_cast<uint8_t>(v & 0xFF));
        put8(at + 1, static_cast<uint8_t>(v >> 8));
    }
    void put32(size_t at, uint32_t v)
    {
        put16(at, static_cast<uint16_t>(v & 0xFFFF));
        put16(at + 2, static_cast<uint16_t>(v >> 16));
    }
    void put_float(size_t at, float v)
    {
        uint32_t bits = 0;
        static_assert(sizeof bits == sizeof v, "the format stores IEEE binary32");
        std::memcpy(&bits, &v, sizeof bits);
        put32(at, bits);
    }
    std::vector<uint8_t> take() { return std::move(bytes_); }
    uint32_t crc(size_t size) const { return crc32(0, bytes_.data(), size); }

private:
    std::vector<uint8_t> bytes_;
};

uint32_t crc_of(const std::vector<uint8_t>& bytes)
{
    return crc32(0, bytes.data(), bytes.size());
}

constexpr uint64_t aligned(uint64_t size)
{
    return (size + format::kSectionAlignment - 1) / format::kSectionAlignment * format::kSectionAlignment;
}

struct Section {
    uint32_t type;
    uint64_t size;
    uint32_t crc;
};

std::vector<uint8_t> layout_section(const FieldLayout& layout)
{
    namespace at = format::layout;
    Bytes b(format::kLayoutBytes);
    b.put32(at::kOriginsAt, layout.origins);
    b.put32(at::kDirectionsAt, layout.directions);
    b.put32(at::kUsedOriginsAt, layout.used_origins);
    b.put32(at::kRowStrideAt, layout.row_stride());
    b.put8(at::kTexelFormatAt, static_cast<uint8_t>(layout.texel));
    b.put8(at::kColourSpaceAt, static_cast<uint8_t>(format::ColourSpace::srgb));
    for (size_t axis = 0; axis < 3; ++axis) {
        b.put_float(at::kCentreAt + 4 * axis, layout.centre[axis]);
    }
    b.put_float(at::kRadiusAt, layout.radius);
    return b.take();
}

std::vector<uint8_t> palette_section(const Palette& palette)
{
    std::vector<uint8_t> bytes;
    for (const Rgba8& c : palette) {
        bytes.insert(bytes.end(), {c.r, c.g, c.b, c.a});
    }
    return bytes;
}

uint64_t head_bytes(size_t sections)
{
    return aligned(format::kHeaderBytes + sections * format::kEntryBytes);
}

std::vector<uint8_t> section_table(const std::vector<Section>& sections)
{
    namespace at = format::entry;
    Bytes b(sections.size() * format::kEntryBytes);
    uint64_t offset = head_bytes(sections.size());
    for (size_t k = 0; k < sections.size(); ++k) {
        const size_t entry = k * format::kEntryBytes;
        b.put32(entry + at::kTypeAt, sections[k].type);
        b.put32(entry + at::kFlagsAt, format::kRequired);
        b.put32(entry + at::kOffsetAt, static_cast<uint32_t>(offset));
        b.put32(entry + at::kSizeAt, static_cast<uint32_t>(sections[k].size));
        b.put32(entry + at::kCrcAt, sections[k].crc);
        offset += aligned(sections[k].size);
    }
    return b.take();
}

std::vector<uint8_t> file_header(uint64_t size, const std::vector<uint8_t>& table)
{
    namespace at = format::header;
    Bytes b(format::kHeaderBytes);
    for (size_t k = 0; k < sizeof format::kMagic; ++k) {
        b.put8(at::kMagicAt + k, format::kMagic[k]);
    }
    b.put16(at::kVersionAt, format::kVersion);
    b.put16(at::kHeaderBytesAt, static_cast<uint16_t>(format::kHeaderBytes));
    b.put32(at::kFileBytesAt, static_cast<uint32_t>(size));
    b.put16(at::kSectionCountAt, static_cast<uint16_t>(table.size() / format::kEntryBytes));
    b.put16(at::kEntryBytesAt, static_cast<uint16_t>(format::kEntryBytes));
    b.put32(at::kTableCrcAt, crc_of(table));
    b.put32(at::kHeaderCrcAt, b.crc(at::kHeaderCrcAt));
    return b.take();
}

void append_padding(NewFile& out, uint64_t size)
{
    out.append(std::vector<uint8_t>(aligned(size) - size));
}

Section append_section(uint32_t type, const std::vector<uint8_t>& bytes, NewFile& out)
{
    out.append(bytes);
    append_padding(out, bytes.size());
    return {type, bytes.size(), crc_of(bytes)};
}

Section append_texels(const FieldLayout& layout, const RowSource& texels, NewFile& out)
{
    Section section = {format::kTexelSection, layout.texel_bytes(), 0};
    std::vector<uint8_t> row(layout.row_stride());
    for (uint32_t i = 0; i < layout.used_origins; ++i) {
        texels(i, row);
        out.append(row);
        section.crc = crc32(section.crc, row.data(), row.size());
    }
    append_padding(out, section.size);
    return section;
}

}  // namespace

uint64_t file_bytes(const FieldLayout& layout)
{
    const bool palette = layout.texel == format::TexelFormat::palette8;
    return head_bytes(palette ? 3 : 2) + aligned(format::kLayoutBytes) + aligned(layout.texel_bytes()) +
           (palette ? aligned(format::kPaletteBytes) : 0);
}

void write_field(const FieldLayout& layout, const RowSource& texels, const Palette& palette, NewFile& out)
{
    const bool has_palette = layout.texel == format::TexelFormat::palette8;
    out.append(std::vector<uint8_t>(head_bytes(has_palette ? 3 : 2)));  // known when the sections' CRCs are
    std::vector<Section> sections;
    sections.push_back(append_section(format::kLayoutSection, layout_section(layout), out));
    sections.push_back(append_texels(layout, texels, out));
    if (has_palette) {
        sections.push_back(append_section(format::kPaletteSection, palette_section(palette), out));
    }
    const std::vector<uint8_t> table = section_table(sections);
    out.overwrite(0, file_header(file_bytes(layout), table));
    out.overwrite(format::kHeaderBytes, table);
}

}  // namespace lumi::baker
