// SPDX-License-Identifier: MIT
// A field L(i,j), read in place: radiance of the ray from origin point i to direction point j (LumiPath, section 2.1).
//
// The caller owns the bytes (usually memory-mapped flash) and keeps them alive and unchanged while the Field is used.
// open_field() checks everything that decides where bytes are read, so no later call can leave the buffer;
// verify_field() reads every byte and tells whether they are the ones that were written.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "lumi/detail/lattice.h"
#include "lumi/field_format.h"

namespace lumi
{

enum class [[nodiscard]] FieldError : uint8_t{
    none = 0,
    truncated,            // fewer bytes than the header says, or than a header takes
    trailing_bytes,       // more bytes than the header says
    bad_magic,            // not a field file
    unsupported_version,  // written by a later version
    bad_header,           // a header field has a value that version 1 does not allow
    header_crc,           // the header's bytes are damaged
    table_crc,            // the section table's bytes are damaged
    bad_section,          // a section lies outside the file, overlaps the table, is unaligned or has unknown flags
    duplicate_section,    // a type that may occur once occurs twice
    unknown_required,     // a required section of a type that this reader does not know
    missing_layout,
    missing_texels,
    missing_palette,
    bad_layout,        // the layout section has the wrong size or its reserved bytes are not zero
    bad_lattice_size,  // M or N is 0 or above kMaxLatticeSize, or the used origins are not in 1 .. M
    bad_texel_format,
    bad_colour_space,
    bad_row_stride,   // shorter than a row, or a power of two
    bad_bounds,       // the sphere's centre is not finite, or its radius not finite and positive
    bad_texel_size,   // the texel section is not used_origins × row_stride bytes
    bad_palette,      // the palette section has the wrong size, or an entry that is not premultiplied
    guided_field,     // the file holds a guided field, which no reader knows any more
    chord_field,      // open_surface only: the file holds a chord field
    surface_field,    // open_field only: the file holds a surface field, see open_surface in surface_field.h
    missing_surface,  // open_surface only: not a surface field
    bad_surface,      // the surface section has the wrong size, or a count, a flag or a reserved byte out of range
    bad_vertices,     // the wrong size, or a vertex outside the sphere
    bad_patches,      // the wrong size, a corner that does not exist, or a rectangle that leaves the texels
    bad_neighbours,   // the wrong size, or a triangle that does not exist
    bad_views,        // the view tables have the wrong size
    section_crc,      // verify_field only: a section's bytes are damaged
};

// One short English phrase per error, for logs. Linked only if called.
const char* describe(FieldError error);

struct Field {
    Lattice origins;
    Lattice directions;
    uint32_t used_origins = 0;
    uint32_t row_stride_bytes = 0;
    const uint8_t* texels = nullptr;   // used_origins rows of row_stride_bytes
    const uint8_t* palette = nullptr;  // kPaletteBytes, or null
    format::TexelFormat texel_format = format::TexelFormat::rgb888;
    format::ColourSpace colour_space = format::ColourSpace::srgb;
    uint32_t centre_bits[3] = {};  // IEEE binary32 patterns: core never computes with them
    uint32_t radius_bits = 0;

    // Row i; null for an origin outside the cap.
    const uint8_t* row(uint32_t i) const
    {
        return i < used_origins ? texels + static_cast<size_t>(i) * row_stride_bytes : nullptr;
    }
};

// Checks `size` bytes and fills `out`; `out` stays untouched on failure. Cost: a CRC over the header and the table.
FieldError open_field(const uint8_t* bytes, size_t size, Field& out);

// Checks the CRC of every section of a file that open_field or open_surface accepted: container and bytes of either
// kind, without the code that reads them. Cost: reads the whole file once.
FieldError verify_field(const uint8_t* bytes, size_t size);

}  // namespace lumi
