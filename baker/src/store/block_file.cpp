// SPDX-License-Identifier: MIT
#include "store/block_file.h"

#include <cassert>
#include <cstring>

#include "util/gzip.h"

namespace lumi::baker
{
namespace
{

constexpr char kMagic[] = "LUMIROWS";
constexpr size_t kMagicBytes = sizeof kMagic - 1;
constexpr uint32_t kVersion = 10;

std::vector<uint8_t> read_head(const PosixFile& file)
{
    std::vector<uint8_t> head(kHeadBytes);
    head.resize(file.read_at(0, head.data(), head.size()));
    const std::string name = file.path().string();
    constexpr size_t kLeast = kMagicBytes + 4;  // version 2 had a shorter head
    if (head.size() < kLeast || std::memcmp(head.data(), kMagic, kMagicBytes) != 0) {
        throw BakeError(
            name + ": is no file of baked rows, or its head is damaged; if it is not needed, remove it and bake again");
    }
    const uint32_t version = ByteReader(head.data() + kMagicBytes, 4).get32();
    if (version != kVersion) {
        throw BakeError(name + ": holds rows in format " + std::to_string(version) + ", this lumi reads format " +
                        std::to_string(kVersion) + "; go on with the lumi that began it, or remove it and bake again");
    }
    const size_t crc_at = kHeadBytes - kSealBytes;
    if (head.size() < kHeadBytes ||
        ByteReader(head.data() + crc_at, kSealBytes).get32() != checksum(0, head.data(), crc_at))
        throw BakeError(name + ": its head is damaged (CRC); remove it and bake again");
    return head;
}

}  // namespace

std::vector<uint8_t> encode_head(const BakeIdentity& identity)
{
    ByteWriter out;
    for (size_t k = 0; k < kMagicBytes; ++k) out.put8(static_cast<uint8_t>(kMagic[k]));
    out.put32(kVersion);
    for (const uint8_t b : encode(identity)) out.put8(b);
    out.put32(checksum(0, out.bytes().data(), out.bytes().size()));
    return out.bytes();
}

BlockFile::BlockFile(std::unique_ptr<PosixFile> file)
    : file_(std::move(file)),
      head_(read_head(*file_)),
      identity_(decode_identity(head_.data() + kMagicBytes + 4)),
      // Without the CRC at its end: with it, every head would have the same one.
      head_crc_(checksum(0, head_.data(), head_.size() - kSealBytes))
{
}

uint32_t BlockFile::seal(uint32_t number, const std::vector<uint8_t>& bytes) const
{
    ByteWriter prefix;
    prefix.put32(number);
    return checksum(checksum(head_crc_, prefix.bytes().data(), prefix.bytes().size()), bytes.data(), bytes.size());
}

bool BlockFile::read(const Block& block, std::vector<uint8_t>& bytes) const
{
    const uint64_t all = file_->size();
    if (block.size > all || block.offset > all || block.end() > all)
        return false;  // before memory is taken for it; sums of hostile sizes may wrap
    bytes.resize(block.size);
    uint8_t stored[kSealBytes];
    return file_->read_at(block.offset, stored, kSealBytes) == kSealBytes &&
           file_->read_at(block.offset + kSealBytes, bytes.data(), bytes.size()) == bytes.size() &&
           ByteReader(stored, kSealBytes).get32() == seal(block.number, bytes);
}

void BlockFile::write(const Block& block, const std::vector<uint8_t>& bytes)
{
    assert(bytes.size() == block.size);
    ByteWriter out;
    out.put32(seal(block.number, bytes));
    std::vector<uint8_t> sealed = out.bytes();
    sealed.insert(sealed.end(), bytes.begin(), bytes.end());
    file_->write_at(block.offset, sealed.data(), sealed.size());
}

}  // namespace lumi::baker
