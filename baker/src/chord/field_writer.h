// SPDX-License-Identifier: MIT
// Lays out and writes chord fields, version 1 (lumi/field_format.h), and keeps the finished rows of their bakes.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "image/palette.h"
#include "lumi/chord/format.h"
#include "store/bake_identity.h"
#include "store/block_file.h"
#include "store/posix_file.h"
#include "store/shard_set.h"

namespace lumi::baker
{

struct FieldLayout {
    uint32_t origins, directions, used_origins;
    TexelFormat texel;
    std::array<float, 3> centre;  // scene units, scene axes
    float radius;

    uint32_t row_stride() const { return detail::format::padded_row_stride(directions, texel); }
    uint64_t texel_bytes() const { return uint64_t{row_stride()} * used_origins; }
};

// Length of the whole file; may exceed what the format's 32-bit offsets can hold.
uint64_t file_bytes(const FieldLayout& layout);

// Fills in row i, which has layout.row_stride() bytes, and may throw.
using RowSource = std::function<void(uint32_t i, std::vector<uint8_t>& row)>;

// Asks for each row once, in order. `palette` is written for palette8 only. Throws BakeError. Memory: one row.
void write_field(const FieldLayout& layout, const RowSource& texels, const Palette& palette, NewFile& out);

// The layout that the settings of a bake ask for, without centre and radius. Throws BakeError for settings that no
// field can hold.
FieldLayout checked_layout(const BakeSettings& settings);

// The layout of a chord bake's field. Throws BakeError for settings or shards that cannot be.
FieldLayout layout_of(const BakeIdentity& identity);

// Throws BakeError for settings or shards that cannot be.
BakeIdentity identity_of(const Scene& scene, const BakeSettings& settings, const Shard& shard);

// The blocks of a chord bake are finished rows:
//
//   palette   256 entries; palette8 only
//   slots     row of texels; one for each row of the shard, in order
class RowFile
{
public:
    // Borrows `file`, which must be of a chord bake.
    explicit RowFile(BlockFile& file);

    const std::filesystem::path& path() const { return file_.path(); }
    const FieldLayout& layout() const { return layout_; }
    uint32_t slot_count() const { return rows_.size(); }
    uint32_t row_of(uint32_t slot) const { return rows_.row(slot); }
    uint64_t complete_bytes() const { return slot_offset(slot_count()); }
    // The slots that do not reach beyond the file's end.
    uint32_t slots_within_file() const;

    // False if it is not there; the output is then unspecified. `row` gets layout().row_stride() bytes. Thread-safe.
    bool read_row(uint32_t slot, std::vector<uint8_t>& row) const;
    void write_row(uint32_t slot, const std::vector<uint8_t>& row);
    // True where no palette is needed.
    bool read_palette(Palette& palette) const;
    void write_palette(const Palette& palette);
    bool has_intact_palette() const;

private:
    bool has_palette() const { return layout_.texel == TexelFormat::palette8; }
    uint64_t slot_offset(uint32_t slot) const;
    Block row_block(uint32_t slot) const { return {slot_offset(slot), row_of(slot), layout_.row_stride()}; }

    BlockFile& file_;
    FieldLayout layout_;
    ShardRows rows_;
};

// Slots whose rows are not there; reads the whole file.
std::vector<uint32_t> missing_slots(const RowFile& rows);

}  // namespace lumi::baker
