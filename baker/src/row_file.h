// SPDX-License-Identifier: MIT
// The file format of checkpoints and shards: finished rows, each under a seal of its own.
//
//   head      "LUMIROWS", version, identity of the bake, CRC; kHeadBytes
//   palette   seal, 256 entries; palette8 only
//   slots     seal, row of texels; one for each row of the shard, in order
//
// Slots have fixed places and are written in any order, so that finishing a row is one write and no log of what is done
// is needed: a seal is the CRC-32 of the head, the row's number and its bytes. A slot that was never written, that was
// torn by a loss of power, or that holds bytes of another bake has a seal that does not fit, and the row is simply not
// there.
#pragma once

#include <memory>

#include "bake_identity.h"
#include "bake_layout.h"
#include "palette.h"
#include "posix_file.h"

namespace lumi::baker
{

inline constexpr size_t kHeadBytes = 8 + 4 + kIdentityBytes + 4;

// What a new file of rows begins with.
std::vector<uint8_t> encode_head(const BakeIdentity& identity);

class RowFile
{
public:
    // Reads the head. Throws BakeError if there is none, if it is damaged or of another version of the format.
    explicit RowFile(std::unique_ptr<PosixFile> file);

    PosixFile& file() { return *file_; }
    const std::filesystem::path& path() const { return file_->path(); }
    const BakeIdentity& identity() const { return identity_; }
    const FieldLayout& layout() const { return layout_; }
    uint32_t slot_count() const { return rows_.size(); }
    uint32_t row_of(uint32_t slot) const { return rows_.row(slot); }
    uint64_t complete_bytes() const { return slot_offset(slot_count()); }

    // False if it is not there; the output is then unspecified. `row` has layout().row_stride() bytes. Thread-safe.
    bool read_row(uint32_t slot, std::vector<uint8_t>& row) const;
    void write_row(uint32_t slot, const std::vector<uint8_t>& row);
    // True where no palette is needed.
    bool read_palette(Palette& palette) const;
    void write_palette(const Palette& palette);
    bool has_intact_palette() const;

private:
    bool has_palette() const { return layout_.texel == format::TexelFormat::palette8; }
    uint64_t slot_offset(uint32_t slot) const;
    uint32_t seal(uint32_t number, const uint8_t* bytes, size_t size) const;
    bool read_sealed(uint64_t offset, uint32_t number, std::vector<uint8_t>& bytes) const;
    void write_sealed(uint64_t offset, uint32_t number, const std::vector<uint8_t>& bytes);

    std::unique_ptr<PosixFile> file_;
    std::vector<uint8_t> head_;
    BakeIdentity identity_;
    FieldLayout layout_;
    ShardRows rows_;
    uint32_t head_crc_;
};

// Slots whose rows are not there; reads the whole file.
std::vector<uint32_t> missing_slots(const RowFile& rows);

}  // namespace lumi::baker
