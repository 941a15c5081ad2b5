// SPDX-License-Identifier: MIT
#include "chord/field_writer.h"

#include <algorithm>

#include "lumi/detail/crc32.h"
#include "lumi/detail/lattice.h"
#include "store/bake_identity.h"
#include "store/section_writer.h"
#include "store/shard_set.h"
#include "trace/path_tracer.h"

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

namespace
{

std::string lattice_range(const char* name)
{
    return std::string("the number of ") + name + " must lie in 1 to " + std::to_string(detail::kMaxLatticeSize);
}

}  // namespace

FieldLayout checked_layout(const BakeSettings& s)
{
    require(s.origins >= 1 && s.origins <= detail::kMaxLatticeSize, lattice_range("origins"));
    require(s.directions >= 1 && s.directions <= detail::kMaxLatticeSize, lattice_range("directions"));
    require(s.used_origins <= s.origins, "the cap holds " + std::to_string(s.used_origins) + " origins of " +
                                             std::to_string(s.origins) + "; choose at most all of them, or 0 for all");
    require(s.samples >= 1, "the number of samples must be at least 1");
    require(s.max_error_levels >= 0 && s.max_error_levels <= 255,
            "the error at which a texel is settled must lie in 0 to 255 levels");
    require(static_cast<uint32_t>(s.texel) < detail::format::kTexelFormats, "there is no such texel format");
    require(s.footprint <= Footprint::both, "there is no such footprint");
    require(s.beam <= Beam::parallel, "there is no such beam");
    const FieldLayout layout = {s.origins, s.directions, s.used_origins ? s.used_origins : s.origins, s.texel, {}, 1};
    require(file_bytes(layout) <= UINT32_MAX, "the field would have " + std::to_string(file_bytes(layout)) +
                                                  " bytes, and a field file holds less than 4 GiB; choose fewer "
                                                  "origins or directions, a smaller cap or a smaller texel format");
    return layout;
}

FieldLayout layout_of(const BakeIdentity& identity)
{
    check_shard(identity.shard);
    FieldLayout result = checked_layout(std::get<BakeSettings>(identity.settings));
    result.centre = identity.centre;
    result.radius = identity.radius;
    return result;
}

BakeIdentity identity_of(const Scene& scene, const BakeSettings& settings, const Shard& shard)
{
    BakeSettings resolved = settings;
    resolved.used_origins = checked_layout(settings).used_origins;
    return identity_of(scene, resolved, shard, tracing_fingerprint(scene.data()));
}

namespace
{

constexpr Block kPaletteBlock = {kHeadBytes, UINT32_MAX, detail::format::kPaletteBytes};  // no row has that number

std::vector<uint8_t> bytes_of(const Palette& palette)
{
    std::vector<uint8_t> bytes;
    for (const detail::Rgba8& c : palette) bytes.insert(bytes.end(), {c.r, c.g, c.b, c.a});
    return bytes;
}

}  // namespace

RowFile::RowFile(BlockFile& file)
    : file_(file), layout_(layout_of(file.identity())), rows_(layout_.used_origins, file.identity().shard)
{
}

uint64_t RowFile::slot_offset(uint32_t slot) const
{
    const uint64_t first = has_palette() ? kPaletteBlock.end() : kHeadBytes;
    return first + slot * Block{0, 0, layout_.row_stride()}.end();
}

uint32_t RowFile::slots_within_file() const
{
    const uint64_t all = file_.file().size(), first = slot_offset(0), each = slot_offset(1) - first;
    return all < first ? 0 : static_cast<uint32_t>(std::min<uint64_t>((all - first) / each, slot_count()));
}

bool RowFile::read_row(uint32_t slot, std::vector<uint8_t>& row) const
{
    return file_.read(row_block(slot), row);
}

void RowFile::write_row(uint32_t slot, const std::vector<uint8_t>& row)
{
    file_.write(row_block(slot), row);
}

bool RowFile::read_palette(Palette& palette) const
{
    if (!has_palette()) return true;
    std::vector<uint8_t> bytes;
    if (!file_.read(kPaletteBlock, bytes)) return false;
    for (size_t k = 0; k < palette.size(); ++k)
        palette[k] = {bytes[4 * k], bytes[4 * k + 1], bytes[4 * k + 2], bytes[4 * k + 3]};
    return true;
}

void RowFile::write_palette(const Palette& palette)
{
    file_.write(kPaletteBlock, bytes_of(palette));
}

bool RowFile::has_intact_palette() const
{
    Palette ignored;
    return read_palette(ignored);
}

std::vector<uint32_t> missing_slots(const RowFile& rows)
{
    std::vector<uint32_t> missing;
    std::vector<uint8_t> row;
    const uint32_t within = rows.slots_within_file();  // a file of a few bytes may say that it has a million
    for (uint32_t slot = 0; slot < rows.slot_count(); ++slot)
        if (slot >= within || !rows.read_row(slot, row)) missing.push_back(slot);
    return missing;
}

}  // namespace lumi::baker
