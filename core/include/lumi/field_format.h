// SPDX-License-Identifier: MIT
// Byte layout of a field file, version 1: header, table, and the names of the sections, which chord/format.h and
// surface/format.h describe. Little-endian; read in place from any address, aligned or not. docs/field-format.md is
// these headers in prose; the writer (baker) and the readers both build on them.
#pragma once
#pragma GCC system_header

#include <stddef.h>
#include <stdint.h>

#include "lumi/detail/compiler.h"

namespace lumi
{

enum class ColourSpace : uint8_t { srgb = 0 };  // 8-bit values are sRGB-encoded (IEC 61966-2-1)

}  // namespace lumi

namespace lumi::detail::format
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

// Chord fields have these: chord/format.h.
inline constexpr uint32_t kLayoutSection = four_cc('L', 'A', 'Y', 'O');   // required, kLayoutBytes
inline constexpr uint32_t kTexelSection = four_cc('T', 'E', 'X', 'L');    // required, used_origins × row_stride
inline constexpr uint32_t kPaletteSection = four_cc('P', 'A', 'L', 'T');  // required with palette8, kPaletteBytes

// Surface fields have these: surface/format.h.
inline constexpr uint32_t kSurfaceSection = four_cc('S', 'U', 'R', 'F');    // required, kSurfaceBytes
inline constexpr uint32_t kVertexSection = four_cc('S', 'V', 'T', 'X');     // required, vertices × kVertexBytes
inline constexpr uint32_t kPatchSection = four_cc('S', 'P', 'A', 'T');      // required, patches × kPatchBytes
inline constexpr uint32_t kColourSection = four_cc('S', 'T', 'E', 'X');     // required, one byte a texel
inline constexpr uint32_t kPaletteRgb = four_cc('S', 'P', 'A', 'L');        // required, 256 × (r, g, b)
inline constexpr uint32_t kViewSection = four_cc('S', 'V', 'I', 'E');       // view tables, where there are any
inline constexpr uint32_t kNeighbourSection = four_cc('S', 'N', 'E', 'I');  // optional, patches × kNeighbourBytes
// Where there are see-through patches, kSeeThroughBytes; required unless all of them are shadows.
inline constexpr uint32_t kSeeThroughSection = four_cc('S', 'S', 'E', 'E');
// Where parts move, required: 4 + parts × kPartBytes.
inline constexpr uint32_t kPartsSection = four_cc('S', 'P', 'R', 'T');
// Where lights have weights that a device chooses, optional: states_bytes().
inline constexpr uint32_t kStateSection = four_cc('S', 'S', 'T', 'A');
// Where smooth surfaces mirror what is around them, required: gloss_bytes().
inline constexpr uint32_t kGlossSection = four_cc('S', 'G', 'L', 'O');
// Optional, four zeros: the field is a first look, coarse and of few light paths.
inline constexpr uint32_t kDraftSection = four_cc('D', 'R', 'F', 'T');

// Guided fields ended with version 0.1.0. Their other names stay reserved, too: PROX, MEAN, CHRT, CPAL, OCCL.
inline constexpr uint32_t kGuidedSection = four_cc('G', 'U', 'I', 'D');

inline constexpr uint32_t kColourSpaces = 1;
inline constexpr uint32_t kPaletteEntries = 256;

}  // namespace lumi::detail::format
