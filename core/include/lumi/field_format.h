// SPDX-License-Identifier: MIT
// Byte layout of a field file, version 1. Little-endian; read in place from any address, aligned or not.
// docs/field-format.md is this header in prose; the writer (baker) and the reader (field.h) both build on it.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "lumi/detail/cpp17.h"

namespace lumi::format
{

inline constexpr uint8_t kMagic[8] = {0x89, 'L', 'U', 'M', 'I', 0x0D, 0x0A, 0x1A};
inline constexpr uint16_t kVersion = 1;

// File header: kHeaderBytes bytes, then section_count entries of kEntryBytes each, then the sections.
inline constexpr uint32_t kHeaderBytes = 32;
namespace header
{
inline constexpr uint32_t kMagicAt = 0;          // 8 bytes
inline constexpr uint32_t kVersionAt = 8;        // u16
inline constexpr uint32_t kHeaderBytesAt = 10;   // u16, = kHeaderBytes
inline constexpr uint32_t kFileBytesAt = 12;     // u32, length of the whole file
inline constexpr uint32_t kSectionCountAt = 16;  // u16, 1 .. kMaxSections
inline constexpr uint32_t kEntryBytesAt = 18;    // u16, = kEntryBytes
inline constexpr uint32_t kReservedAt = 20;      // u32, 0
inline constexpr uint32_t kTableCrcAt = 24;      // u32, CRC-32 of the section table
inline constexpr uint32_t kHeaderCrcAt = 28;     // u32, CRC-32 of bytes 0 .. 27
}  // namespace header

inline constexpr uint32_t kEntryBytes = 20;
inline constexpr uint32_t kMaxSections = 64;
namespace entry
{
inline constexpr uint32_t kTypeAt = 0;    // u32, four characters
inline constexpr uint32_t kFlagsAt = 4;   // u32, kRequired or 0; other bits must be 0
inline constexpr uint32_t kOffsetAt = 8;  // u32, from the start of the file, a multiple of kSectionAlignment
inline constexpr uint32_t kSizeAt = 12;   // u32, bytes
inline constexpr uint32_t kCrcAt = 16;    // u32, CRC-32 of the section's bytes
}  // namespace entry
inline constexpr uint32_t kRequired = 1;  // a reader that does not know the type must refuse the file
inline constexpr uint32_t kSectionAlignment = 8;

constexpr uint32_t four_cc(char a, char b, char c, char d)
{
    return static_cast<uint32_t>(static_cast<uint8_t>(a)) | static_cast<uint32_t>(static_cast<uint8_t>(b)) << 8 |
           static_cast<uint32_t>(static_cast<uint8_t>(c)) << 16 | static_cast<uint32_t>(static_cast<uint8_t>(d)) << 24;
}

inline constexpr uint32_t kLayoutSection = four_cc('L', 'A', 'Y', 'O');   // required, kLayoutBytes
inline constexpr uint32_t kTexelSection = four_cc('T', 'E', 'X', 'L');    // required, used_origins × row_stride
inline constexpr uint32_t kPaletteSection = four_cc('P', 'A', 'L', 'T');  // required with palette8, kPaletteBytes

// Of guided fields, which ended with version 0.1.0. Its other names are reserved, too: PROX, MEAN, CHRT, CPAL, OCCL.
inline constexpr uint32_t kGuidedSection = four_cc('G', 'U', 'I', 'D');

inline constexpr uint32_t kLayoutBytes = 36;
namespace layout
{
inline constexpr uint32_t kOriginsAt = 0;       // u32, M: points of the origin lattice, 1 .. kMaxLatticeSize
inline constexpr uint32_t kDirectionsAt = 4;    // u32, N: points of the direction lattice, 1 .. kMaxLatticeSize
inline constexpr uint32_t kUsedOriginsAt = 8;   // u32, rows present: origins 0 .. used-1, a cap around +z; 1 .. M
inline constexpr uint32_t kRowStrideAt = 12;    // u32, bytes from row to row, see padded_row_stride
inline constexpr uint32_t kTexelFormatAt = 16;  // u8, TexelFormat
inline constexpr uint32_t kColourSpaceAt = 17;  // u8, ColourSpace
inline constexpr uint32_t kReservedAt = 18;     // u16, 0
inline constexpr uint32_t kCentreAt = 20;       // 3 × IEEE binary32: the sphere's centre, scene units, scene axes
inline constexpr uint32_t kRadiusAt = 32;       // IEEE binary32 > 0: the sphere's radius, scene units
}  // namespace layout

enum class TexelFormat : uint8_t { rgb888 = 0, rgb565 = 1, palette8 = 2, luma8 = 3 };
inline constexpr uint32_t kTexelFormats = 4;

enum class ColourSpace : uint8_t { srgb = 0 };  // 8-bit values are sRGB-encoded (IEC 61966-2-1)
inline constexpr uint32_t kColourSpaces = 1;

// 256 entries of (r, g, b, a), premultiplied: a is coverage, r, g, b <= a.
inline constexpr uint32_t kPaletteEntries = 256;
inline constexpr uint32_t kPaletteBytes = kPaletteEntries * 4;

constexpr uint32_t bytes_per_texel(TexelFormat format)
{
    return format == TexelFormat::rgb888 ? 3 : format == TexelFormat::rgb565 ? 2 : 1;
}

// The row stride a writer uses: the smallest odd multiple of 8 bytes, at least 24, that holds a row. Rows that lie
// a power of two apart fall into the same set of a cache: 4 times the misses for 3×3 taps in a 16 KB cache.
constexpr uint32_t padded_row_stride(uint32_t directions, TexelFormat format)
{
    const uint32_t units = (directions * bytes_per_texel(format) + 7) / 8;
    const uint32_t odd_units = units | 1;
    return 8 * (odd_units < 3 ? 3 : odd_units);
}

constexpr bool is_power_of_two(uint32_t value)
{
    return value != 0 && (value & (value - 1)) == 0;
}

}  // namespace lumi::format
