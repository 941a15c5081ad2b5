// SPDX-License-Identifier: MIT
// Byte layout of a chord field: the sections that a file of field_format.h holds for it. Little-endian. Offsets are
// within the layout section.
#pragma once
#pragma GCC system_header

#include "lumi/field_format.h"

namespace lumi
{

enum class TexelFormat : uint8_t { rgb888 = 0, rgb565 = 1, palette8 = 2, luma8 = 3 };

}  // namespace lumi

namespace lumi::detail::format
{

inline constexpr uint32_t kTexelFormats = 4;

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

// 256 entries of (r, g, b, a), premultiplied: a is coverage, r, g, b <= a.
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

}  // namespace lumi::detail::format
