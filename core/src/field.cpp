// SPDX-License-Identifier: MIT
#include "lumi/field.h"

#include "lumi/crc32.h"

namespace lumi
{
namespace
{

using namespace format;

uint32_t load_u16(const uint8_t* p)
{
    return static_cast<uint32_t>(p[0]) | static_cast<uint32_t>(p[1]) << 8;
}

uint32_t load_u32(const uint8_t* p)
{
    return load_u16(p) | load_u16(p + 2) << 16;
}

struct Section {
    uint32_t type, flags, offset, size, crc;
};

Section section_at(const uint8_t* bytes, uint32_t index)
{
    const uint8_t* e = bytes + kHeaderBytes + index * kEntryBytes;
    return {load_u32(e + entry::kTypeAt), load_u32(e + entry::kFlagsAt), load_u32(e + entry::kOffsetAt),
            load_u32(e + entry::kSizeAt), load_u32(e + entry::kCrcAt)};
}

uint32_t section_count(const uint8_t* bytes)
{
    return load_u16(bytes + header::kSectionCountAt);
}

FieldError check_header(const uint8_t* bytes, size_t size)
{
    if (size < kHeaderBytes) return FieldError::truncated;
    for (size_t i = 0; i < sizeof kMagic; ++i) {
        if (bytes[i] != kMagic[i]) return FieldError::bad_magic;
    }
    if (load_u32(bytes + header::kHeaderCrcAt) != crc32(0, bytes, header::kHeaderCrcAt)) return FieldError::header_crc;
    if (load_u16(bytes + header::kVersionAt) != kVersion) return FieldError::unsupported_version;
    const uint32_t count = section_count(bytes);
    if (load_u16(bytes + header::kHeaderBytesAt) != kHeaderBytes ||
        load_u16(bytes + header::kEntryBytesAt) != kEntryBytes || count == 0 || count > kMaxSections ||
        load_u32(bytes + header::kReservedAt) != 0) {
        return FieldError::bad_header;
    }
    const uint32_t file_bytes = load_u32(bytes + header::kFileBytesAt);
    if (size < file_bytes || size < kHeaderBytes + count * kEntryBytes) return FieldError::truncated;
    return size > file_bytes ? FieldError::trailing_bytes : FieldError::none;
}

bool lies_inside(const Section& s, uint32_t first_byte, uint32_t file_bytes)
{
    return s.offset >= first_byte && s.offset <= file_bytes && s.size <= file_bytes - s.offset;
}

bool is_known(uint32_t type)
{
    return type == kLayoutSection || type == kTexelSection || type == kPaletteSection;
}

bool occurs_before(const uint8_t* bytes, uint32_t type, uint32_t end)
{
    for (uint32_t i = 0; i < end; ++i) {
        if (section_at(bytes, i).type == type) return true;
    }
    return false;
}

FieldError check_table(const uint8_t* bytes, uint32_t file_bytes)
{
    const uint32_t count = section_count(bytes);
    const uint32_t table_bytes = count * kEntryBytes;
    if (load_u32(bytes + header::kTableCrcAt) != crc32(0, bytes + kHeaderBytes, table_bytes)) {
        return FieldError::table_crc;
    }
    for (uint32_t i = 0; i < count; ++i) {
        const Section s = section_at(bytes, i);
        if (!lies_inside(s, kHeaderBytes + table_bytes, file_bytes) || s.offset % kSectionAlignment != 0 ||
            (s.flags & ~kRequired) != 0) {
            return FieldError::bad_section;
        }
        if (!is_known(s.type) && (s.flags & kRequired) != 0) return FieldError::unknown_required;
        if (is_known(s.type) && occurs_before(bytes, s.type, i)) return FieldError::duplicate_section;
    }
    return FieldError::none;
}

// Sets `out` where the type occurs; check_table made sure that it occurs at most once.
bool find_section(const uint8_t* bytes, uint32_t type, Section& out)
{
    for (uint32_t i = 0; i < section_count(bytes); ++i) {
        out = section_at(bytes, i);
        if (out.type == type) return true;
    }
    return false;
}

bool is_finite(uint32_t binary32)
{
    return (binary32 & 0x7F800000u) != 0x7F800000u;
}

bool is_positive(uint32_t binary32)
{
    return binary32 != 0 && (binary32 & 0x80000000u) == 0;
}

FieldError read_bounds(const uint8_t* layout, Field& out)
{
    for (uint32_t k = 0; k < 3; ++k) {
        out.centre_bits[k] = load_u32(layout + layout::kCentreAt + 4 * k);
        if (!is_finite(out.centre_bits[k])) return FieldError::bad_bounds;
    }
    out.radius_bits = load_u32(layout + layout::kRadiusAt);
    return is_finite(out.radius_bits) && is_positive(out.radius_bits) ? FieldError::none : FieldError::bad_bounds;
}

FieldError read_lattices(const uint8_t* layout, Field& out)
{
    const uint32_t origins = load_u32(layout + layout::kOriginsAt);
    const uint32_t directions = load_u32(layout + layout::kDirectionsAt);
    out.used_origins = load_u32(layout + layout::kUsedOriginsAt);
    if (origins == 0 || origins > kMaxLatticeSize || directions == 0 || directions > kMaxLatticeSize ||
        out.used_origins == 0 || out.used_origins > origins) {
        return FieldError::bad_lattice_size;
    }
    out.origins = Lattice(origins);
    out.directions = Lattice(directions);
    return FieldError::none;
}

FieldError read_layout(const uint8_t* layout, Field& out)
{
    if (load_u16(layout + layout::kReservedAt) != 0) return FieldError::bad_layout;
    const uint8_t texel_format = layout[layout::kTexelFormatAt];
    const uint8_t colour_space = layout[layout::kColourSpaceAt];
    if (texel_format >= kTexelFormats) return FieldError::bad_texel_format;
    if (colour_space >= kColourSpaces) return FieldError::bad_colour_space;
    out.texel_format = static_cast<TexelFormat>(texel_format);
    out.colour_space = static_cast<ColourSpace>(colour_space);
    if (const FieldError error = read_lattices(layout, out); error != FieldError::none) return error;
    out.row_stride_bytes = load_u32(layout + layout::kRowStrideAt);
    if (out.row_stride_bytes < out.directions.size() * bytes_per_texel(out.texel_format) ||
        is_power_of_two(out.row_stride_bytes)) {
        return FieldError::bad_row_stride;
    }
    return read_bounds(layout, out);
}

FieldError read_texels(const uint8_t* bytes, Field& out)
{
    Section texels;
    if (!find_section(bytes, kTexelSection, texels)) return FieldError::missing_texels;
    if (static_cast<uint64_t>(out.used_origins) * out.row_stride_bytes != texels.size) {
        return FieldError::bad_texel_size;
    }
    out.texels = bytes + texels.offset;
    return FieldError::none;
}

bool is_premultiplied(const uint8_t* palette)
{
    for (uint32_t i = 0; i < kPaletteEntries; ++i) {
        const uint8_t* e = palette + 4 * i;
        if (e[0] > e[3] || e[1] > e[3] || e[2] > e[3]) return false;
    }
    return true;
}

FieldError read_palette(const uint8_t* bytes, Field& out)
{
    Section palette;
    const bool present = find_section(bytes, kPaletteSection, palette);
    if (present && palette.size != kPaletteBytes) return FieldError::bad_palette;
    if (!present && out.texel_format == TexelFormat::palette8) return FieldError::missing_palette;
    if (!present) return FieldError::none;
    if (!is_premultiplied(bytes + palette.offset)) return FieldError::bad_palette;
    out.palette = bytes + palette.offset;
    return FieldError::none;
}

}  // namespace

FieldError open_field(const uint8_t* bytes, size_t size, Field& out)
{
    if (const FieldError error = check_header(bytes, size); error != FieldError::none) return error;
    if (const FieldError error = check_table(bytes, static_cast<uint32_t>(size)); error != FieldError::none) {
        return error;
    }
    Section section;
    if (!find_section(bytes, kLayoutSection, section)) return FieldError::missing_layout;
    if (section.size != kLayoutBytes) return FieldError::bad_layout;
    Field field;
    if (const FieldError error = read_layout(bytes + section.offset, field); error != FieldError::none) return error;
    if (const FieldError error = read_texels(bytes, field); error != FieldError::none) return error;
    if (const FieldError error = read_palette(bytes, field); error != FieldError::none) return error;
    out = field;
    return FieldError::none;
}

FieldError verify_field(const uint8_t* bytes, size_t size)
{
    Field field;
    if (const FieldError error = open_field(bytes, size, field); error != FieldError::none) return error;
    for (uint32_t i = 0; i < section_count(bytes); ++i) {
        const Section s = section_at(bytes, i);
        if (crc32(0, bytes + s.offset, s.size) != s.crc) return FieldError::section_crc;
    }
    return FieldError::none;
}

const char* describe(FieldError error)
{
    switch (error) {
        case FieldError::none:
            return "no error";
        case FieldError::truncated:
            return "the file is shorter than its header says";
        case FieldError::trailing_bytes:
            return "the file is longer than its header says";
        case FieldError::bad_magic:
            return "not a field file";
        case FieldError::unsupported_version:
            return "written in a later version of the format";
        case FieldError::bad_header:
            return "the header has a value that this version does not allow";
        case FieldError::header_crc:
            return "the header's bytes are damaged";
        case FieldError::table_crc:
            return "the section table's bytes are damaged";
        case FieldError::bad_section:
            return "a section lies outside the file or is unaligned";
        case FieldError::duplicate_section:
            return "a section occurs twice";
        case FieldError::unknown_required:
            return "the field needs a feature that this reader does not know";
        case FieldError::missing_layout:
            return "the layout section is missing";
        case FieldError::missing_texels:
            return "the texel section is missing";
        case FieldError::missing_palette:
            return "the palette section is missing";
        case FieldError::bad_layout:
            return "the layout section is malformed";
        case FieldError::bad_lattice_size:
            return "a lattice size is out of range";
        case FieldError::bad_texel_format:
            return "unknown texel format";
        case FieldError::bad_colour_space:
            return "unknown colour space";
        case FieldError::bad_row_stride:
            return "the row stride is too short or a power of two";
        case FieldError::bad_bounds:
            return "the bounding sphere is not finite and positive";
        case FieldError::bad_texel_size:
            return "the texel section has the wrong size";
        case FieldError::bad_palette:
            return "the palette has the wrong size or an entry brighter than its coverage";
        case FieldError::section_crc:
            return "a section's bytes are damaged";
    }
    return "unknown error";
}

}  // namespace lumi
