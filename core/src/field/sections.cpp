// SPDX-License-Identifier: MIT
#include "field/sections.h"

#include "lumi/detail/crc32.h"

namespace lumi::detail::container
{
namespace
{

using namespace format;

FieldError check_header(const uint8_t* bytes, size_t size)
{
    if (size < kHeaderBytes) return FieldError::truncated;
    for (size_t i = 0; i < sizeof kMagic; ++i)
        if (bytes[i] != kMagic[i]) return FieldError::bad_magic;
    if (load_u32(bytes + header::kHeaderCrcAt) != crc32(0, bytes, header::kHeaderCrcAt)) return FieldError::header_crc;
    if (load_u16(bytes + header::kVersionAt) != kVersion) return FieldError::unsupported_version;
    const uint32_t count = section_count(bytes);
    if (load_u16(bytes + header::kHeaderBytesAt) != kHeaderBytes ||
        load_u16(bytes + header::kEntryBytesAt) != kEntryBytes || count == 0 || count > kMaxSections ||
        load_u32(bytes + header::kReservedAt) != 0)
        return FieldError::bad_header;
    const uint32_t file_bytes = load_u32(bytes + header::kFileBytesAt);
    if (size < file_bytes || size < kHeaderBytes + count * kEntryBytes) return FieldError::truncated;
    return size > file_bytes ? FieldError::trailing_bytes : FieldError::none;
}

bool lies_inside(const Section& s, uint32_t first_byte, uint32_t file_bytes)
{
    return s.offset >= first_byte && s.offset <= file_bytes && s.size <= file_bytes - s.offset;
}

bool occurs_before(const uint8_t* bytes, uint32_t type, uint32_t end)
{
    for (uint32_t i = 0; i < end; ++i)
        if (section_at(bytes, i).type == type) return true;
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

}  // namespace

uint32_t section_count(const uint8_t* bytes)
{
    return load_u16(bytes + header::kSectionCountAt);
}

Section section_at(const uint8_t* bytes, uint32_t index)
{
    const uint8_t* e = bytes + kHeaderBytes + index * kEntryBytes;
    return {load_u32(e + entry::kTypeAt), load_u32(e + entry::kFlagsAt), load_u32(e + entry::kOffsetAt),
            load_u32(e + entry::kSizeAt), load_u32(e + entry::kCrcAt)};
}

FieldError check_table(const uint8_t* bytes, size_t size)
{
    if (const FieldError error = check_header(bytes, size); error != FieldError::none) return error;
    const uint32_t found = crc32(0, bytes + kHeaderBytes, section_count(bytes) * kEntryBytes);
    return load_u32(bytes + header::kTableCrcAt) == found ? FieldError::none : FieldError::table_crc;
}

FieldError check_sections(const uint8_t* bytes, KnownTypes known)
{
    const uint32_t count = section_count(bytes);
    const uint32_t first_byte = kHeaderBytes + count * kEntryBytes;
    const uint32_t file_bytes = load_u32(bytes + header::kFileBytesAt);
    for (uint32_t i = 0; i < count; ++i) {
        const Section s = section_at(bytes, i);
        if (!lies_inside(s, first_byte, file_bytes) || s.offset % kSectionAlignment != 0 || (s.flags & ~kRequired) != 0)
            return FieldError::bad_section;
        if (!known.has(s.type) && (s.flags & kRequired) != 0) return FieldError::unknown_required;
        if (known.has(s.type) && occurs_before(bytes, s.type, i)) return FieldError::duplicate_section;
    }
    return FieldError::none;
}

bool find_section(const uint8_t* bytes, uint32_t type, Section& out)
{
    for (uint32_t i = 0; i < section_count(bytes); ++i) {
        out = section_at(bytes, i);
        if (out.type == type) return true;
    }
    return false;
}

bool has_section(const uint8_t* bytes, uint32_t type)
{
    Section ignored;
    return find_section(bytes, type, ignored);
}

bool read_bounds(const uint8_t* centre, const uint8_t* radius, BoundsBits& out)
{
    out.radius = load_u32(radius);
    bool ok = is_finite(out.radius) && is_positive(out.radius);
    for (uint32_t k = 0; k < 3; ++k) {
        out.centre[k] = load_u32(centre + 4 * k);
        ok = ok && is_finite(out.centre[k]);
    }
    return ok;
}

}  // namespace lumi::detail::container
