// SPDX-License-Identifier: MIT
#include "lumi/chord/field.h"

#include "field/sections.h"

namespace lumi
{
namespace
{

using namespace detail;
using namespace detail::format;
using namespace detail::container;

constexpr uint32_t kChordTypes[] = {kLayoutSection, kTexelSection, kPaletteSection};

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
    if (const FieldError error = check_sections(bytes, known_types(kChordTypes)); error != FieldError::none)
        return error;
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

}  // namespace lumi
