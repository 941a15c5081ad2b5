// SPDX-License-Identifier: MIT
#include "lumi/field.h"

#include "field/sections.h"
#include "lumi/detail/crc32.h"
#include "lumi/surface/format.h"

namespace lumi
{
namespace
{

using namespace format;
using namespace container;

constexpr uint32_t kChordTypes[] = {kLayoutSection, kTexelSection, kPaletteSection};
constexpr uint32_t kAllTypes[] = {kLayoutSection, kTexelSection,  kPaletteSection, kSurfaceSection, kVertexSection,
                                  kPatchSection,  kColourSection, kPaletteRgb,     kViewSection,    kNeighbourSection};

template <uint32_t Count>
constexpr KnownTypes known(const uint32_t (&types)[Count])
{
    return {types, Count};
}

FieldError read_lattices(const uint8_t* layout, Field& out)
{
    const uint32_t origins = load_u32(layout + layout::kOriginsAt);
    const uint32_t directions = load_u32(layout + layout::kDirectionsAt);
    out.used_origins = load_u32(layout + layout::kUsedOriginsAt);
    if (origins == 0 || origins > kMaxLatticeSize || directions == 0 || directions > kMaxLatticeSize ||
        out.used_origins == 0 || out.used_origins > origins)
        return FieldError::bad_lattice_size;
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
        is_power_of_two(out.row_stride_bytes))
        return FieldError::bad_row_stride;
    BoundsBits bounds;
    if (!read_bounds(layout + layout::kCentreAt, layout + layout::kRadiusAt, bounds)) return FieldError::bad_bounds;
    for (uint32_t k = 0; k < 3; ++k) out.centre_bits[k] = bounds.centre[k];
    out.radius_bits = bounds.radius;
    return FieldError::none;
}

FieldError read_texels(const uint8_t* bytes, Field& out)
{
    Section texels;
    if (!find_section(bytes, kTexelSection, texels)) return FieldError::missing_texels;
    if (static_cast<uint64_t>(out.used_origins) * out.row_stride_bytes != texels.size)
        return FieldError::bad_texel_size;
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
    if (const FieldError error = check_table(bytes, size); error != FieldError::none) return error;
    if (has_section(bytes, kGuidedSection)) return FieldError::guided_field;
    if (has_section(bytes, kSurfaceSection)) return FieldError::surface_field;
    if (const FieldError error = check_sections(bytes, known(kChordTypes)); error != FieldError::none) return error;
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
    if (const FieldError error = check_table(bytes, size); error != FieldError::none) return error;
    if (const FieldError error = check_sections(bytes, known(kAllTypes)); error != FieldError::none) return error;
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
            return "the view tables have the wrong size";
        case FieldError::section_crc:
            return "a section's bytes are damaged";
    }
    return "unknown error";
}

}  // namespace lumi
