// SPDX-License-Identifier: MIT
#include "chord/field_writer.h"

#include "lumi/detail/crc32.h"
#include "store/section_writer.h"

namespace lumi::baker
{
namespace
{

std::vector<uint8_t> layout_section(const FieldLayout& layout)
{
    namespace at = detail::format::layout;
    Bytes b(detail::format::kLayoutBytes);
    b.put32(at::kOriginsAt, layout.origins);
    b.put32(at::kDirectionsAt, layout.directions);
    b.put32(at::kUsedOriginsAt, layout.used_origins);
    b.put32(at::kRowStrideAt, layout.row_stride());
    b.put8(at::kTexelFormatAt, static_cast<uint8_t>(layout.texel));
    b.put8(at::kColourSpaceAt, static_cast<uint8_t>(ColourSpace::srgb));
    for (size_t axis = 0; axis < 3; ++axis) b.put_float(at::kCentreAt + 4 * axis, layout.centre[axis]);
    b.put_float(at::kRadiusAt, layout.radius);
    return b.take();
}

std::vector<uint8_t> palette_section(const Palette& palette)
{
    std::vector<uint8_t> bytes;
    for (const detail::Rgba8& c : palette) bytes.insert(bytes.end(), {c.r, c.g, c.b, c.a});
    return bytes;
}

void append_padding(NewFile& out, uint64_t size)
{
    out.append(std::vector<uint8_t>(aligned(size) - size));
}

Section append_section(uint32_t type, const std::vector<uint8_t>& bytes, NewFile& out)
{
    out.append(bytes);
    append_padding(out, bytes.size());
    return {type, bytes.size(), crc_of(bytes)};
}

Section append_texels(const FieldLayout& layout, const RowSource& texels, NewFile& out)
{
    Section section = {detail::format::kTexelSection, layout.texel_bytes(), 0};
    std::vector<uint8_t> row(layout.row_stride());
    for (uint32_t i = 0; i < layout.used_origins; ++i) {
        texels(i, row);
        out.append(row);
        section.crc = detail::crc32(section.crc, row.data(), row.size());
    }
    append_padding(out, section.size);
    return section;
}

}  // namespace

uint64_t file_bytes(const FieldLayout& layout)
{
    const bool palette = layout.texel == TexelFormat::palette8;
    return head_bytes(palette ? 3 : 2) + aligned(detail::format::kLayoutBytes) + aligned(layout.texel_bytes()) +
           (palette ? aligned(detail::format::kPaletteBytes) : 0);
}

void write_field(const FieldLayout& layout, const RowSource& texels, const Palette& palette, NewFile& out)
{
    const bool has_palette = layout.texel == TexelFormat::palette8;
    out.append(std::vector<uint8_t>(head_bytes(has_palette ? 3 : 2)));  // known when the sections' CRCs are
    std::vector<Section> sections;
    sections.push_back(append_section(detail::format::kLayoutSection, layout_section(layout), out));
    sections.push_back(append_texels(layout, texels, out));
    if (has_palette) sections.push_back(append_section(detail::format::kPaletteSection, palette_section(palette), out));
    out.overwrite(0, file_head(sections));
}

}  // namespace lumi::baker
