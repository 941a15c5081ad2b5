// SPDX-License-Identifier: MIT
// The blocks of a chord bake: finished rows.
//
//   palette   256 entries; palette8 only
//   slots     row of texels; one for each row of the shard, in order
#pragma once

#include "chord/field_writer.h"
#include "image/palette.h"
#include "store/bake_identity.h"
#include "store/block_file.h"
#include "store/shard_set.h"

namespace lumi::baker
{

// The layout that a chord bake's settings ask for, and the identity of the bake.

// Without centre and radius. Throws BakeError for settings that no field can hold.
FieldLayout checked_layout(const BakeSettings& settings);

// The layout of a chord bake's field. Throws BakeError for settings or shards that cannot be.
FieldLayout layout_of(const BakeIdentity& identity);

// Throws BakeError for settings or shards that cannot be.
BakeIdentity identity_of(const Scene& scene, const BakeSettings& settings, const Shard& shard);

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
