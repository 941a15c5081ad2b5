// SPDX-License-Identifier: MIT
#include "chord/row_file.h"

#include <algorithm>

namespace lumi::baker
{
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
