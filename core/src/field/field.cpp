// SPDX-License-Identifier: MIT
#include "lumi/field.h"

#include "field/sections.h"
#include "lumi/detail/crc32.h"
#include "lumi/field_format.h"

namespace lumi
{
namespace
{

using namespace detail;
using namespace detail::format;
using namespace detail::container;

constexpr uint32_t kAllTypes[] = {
    kLayoutSection, kTexelSection, kPaletteSection,   kSurfaceSection,    kVertexSection, kPatchSection, kColourSection,
    kPaletteRgb,    kViewSection,  kNeighbourSection, kSeeThroughSection, kPartsSection,  kStateSection, kGlossSection};

}  // namespace

FieldError verify_field(const uint8_t* bytes, size_t size)
{
    if (const FieldError error = check_table(bytes, size); error != FieldError::none) return error;
    if (const FieldError error = check_sections(bytes, known_types(kAllTypes)); error != FieldError::none) return error;
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
        case FieldError::guided_field:
            return "guided fields ended with version 0.1.0";
        case FieldError::chord_field:
            return "a chord field, which this reader does not draw";
        case FieldError::surface_field:
            return "a surface field, which this reader does not draw";
        case FieldError::missing_surface:
            return "the surface section is missing";
        case FieldError::bad_surface:
            return "the surface section is malformed";
        case FieldError::bad_vertices:
            return "the vertices have the wrong size, or one lies outside the sphere";
        case FieldError::bad_patches:
            return "the patches have the wrong size, or one leaves the vertices or the texels";
        case FieldError::bad_neighbours:
            return "the neighbours have the wrong size, or one does not exist";
        case FieldError::bad_views:
            return "the view tables have the wrong size, or are of an older format";
        case FieldError::section_crc:
            return "a section's bytes are damaged";
        case FieldError::see_through:
            return "the field has see-through parts (section SSEE), which this reader does not draw";
        case FieldError::bad_see_through:
            return "the section of see-through parts is malformed";
        case FieldError::parts:
            return "the field has moving parts (section SPRT), which this reader does not draw";
        case FieldError::bad_parts:
            return "the section of moving parts is malformed, or parts share vertices";
        case FieldError::bad_states:
            return "the section of light states is malformed";
        case FieldError::gloss:
            return "the field has gloss maps (section SGLO), which this reader does not draw";
        case FieldError::bad_gloss:
            return "the section of gloss maps is malformed";
    }
    return "unknown error";
}

}  // namespace lumi
