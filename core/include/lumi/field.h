// SPDX-License-Identifier: MIT
// This header names what can be wrong with the file of a field, of either layout (chord/field.h, surface/field.h), and
// tells whether its bytes are the ones that were written.
#pragma once
#pragma GCC system_header

#include <stddef.h>
#include <stdint.h>

#include "lumi/detail/compiler.h"

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
    bad_views,        // the view tables have the wrong size, or an older format
    section_crc,      // verify_field only: a section's bytes are damaged
    see_through,      // open_surface only: see-through parts, which its SurfaceFeatures do not name
    bad_see_through,  // the wrong size, an order that is not known, or a first patch that does not exist
    parts,            // open_surface only: moving parts, which its SurfaceFeatures do not name
    bad_parts,        // the wrong size, a number out of range, or a patch that shares vertices with another part
    bad_states,       // the section of light states has the wrong size, no name, or a number out of range
    gloss,            // open_surface only: gloss maps, which its SurfaceFeatures do not name
    bad_gloss,  // the wrong size, a number out of range, a patch of a part or without view tables, or states beside it
};

// Returns one short English phrase per error, for logs. Linked only if called.
const char* describe(FieldError error);

// Checks the CRC of every section of a file that open_field or open_surface accepted: container and bytes of either
// kind, without the code that reads them. Cost: reads the whole file once.
FieldError verify_field(const uint8_t* bytes, size_t size);

}  // namespace lumi
