// SPDX-License-Identifier: MIT
// The file format of checkpoints and shards: what was dear to trace, in blocks, each under a seal of its own.
//
//   head    "LUMIROWS", version, identity of the bake, CRC; kHeadBytes
//   blocks  seal, bytes; chord/field_writer.h tells which ones a chord bake has
//
// Blocks have fixed places and are written in any order, so that finishing one is one write and no log of what is done
// is needed: a seal is the CRC-32 of the head, the block's number and its bytes. A block that was never written, that
// was torn by a loss of power, or that holds bytes of another bake has a seal that does not fit, and is simply not
// there.
#pragma once

#include <memory>

#include "store/bake_identity.h"
#include "store/posix_file.h"

namespace lumi::baker
{

inline constexpr size_t kSealBytes = 4;
inline constexpr size_t kHeadBytes = 8 + 4 + kIdentityBytes + kSealBytes;

// The bytes that a new file of blocks begins with.
std::vector<uint8_t> encode_head(const BakeIdentity& identity);

struct Block {
    uint64_t offset;  // where the seal begins
    uint32_t number;  // no other block of the file has it
    uint64_t size;    // without the seal

    constexpr uint64_t end() const { return offset + kSealBytes + size; }
};

class BlockFile
{
public:
    // Reads the head. Throws BakeError if there is none, if it is damaged or of another version of the format.
    explicit BlockFile(std::unique_ptr<PosixFile> file);

    PosixFile& file() { return *file_; }
    const std::filesystem::path& path() const { return file_->path(); }
    const BakeIdentity& identity() const { return identity_; }

    // False if it is not there; the output is then unspecified. Both are thread-safe for different blocks.
    bool read(const Block& block, std::vector<uint8_t>& bytes) const;
    void write(const Block& block, const std::vector<uint8_t>& bytes);

private:
    uint32_t seal(uint32_t number, const std::vector<uint8_t>& bytes) const;

    std::unique_ptr<PosixFile> file_;
    std::vector<uint8_t> head_;
    BakeIdentity identity_;
    uint32_t head_crc_;
};

}  // namespace lumi::baker
