// SPDX-License-Identifier: MIT
#include "row_file.h"

#include <cstring>

#include "lumi/crc32.h"

namespace lumi::baker
{
namespace
{

constexpr char kMagic[] = "LUMIROWS";
constexpr size_t kMagicBytes = sizeof kMagic - 1;
constexpr uint32_t kVersion = 2;
constexpr size_t kSealBytes = 4;
constexpr uint32_t kPaletteNumber = UINT32_MAX;  // no row has it

std::vector<uint8_t> read_head(const PosixFile& file)
{
    std::vector<uint8_t> head(kHeadBytes);
    head.resize(file.read_at(0, head.data(), head.size()));
    const std::string name = file.path().string();
    if (head.size() < kHeadBytes || std::memcmp(head.data(), kMagic, kMagicBytes) != 0) {
        throw BakeError(name + ": is no file of baked rows, or its head is damaged; if it is not needed, remove it and bake again");
    }
    const size_t crc_at = kHeadBytes - kSealBytes;
    if (ByteReader(head.data() + crc_at, kSealBytes).get32() != crc32(0, head.data(), crc_at)) {
        throw BakeError(name + ": its head is damaged (CRC); remove it and bake again");
    }
    const uint32_t version = ByteReader(head.data() + kMagicBytes, 4).get32();
    if (version != kVersion) {
        throw BakeError(name + ": holds rows in format " + std::to_string(version) + ", this lumi reads format " +
                        std::to_string(kVersion) + "; go on with the lumi that began it, or remove it and bake again");
    }
    return head;
}

std::vector<uint8_t> bytes_of(const Palette& palette)
{
    std::vector<uint8_t> bytes;
    for (const Rgba8& c : palette) {
        bytes.insert(bytes.end(), {c.r, c.g, c.b, c.a});
    }
    return bytes;
}

}  // namespace

std::vector<uint8_t> encode_head(const BakeIdentity& identity)
{
    ByteWriter out;
    for (size_t k = 0; k < kMagicBytes; ++k) {
        out.put8(static_cast<uint8_t>(kMagic[k]));
    }
    out.put32(kVersion);
    for (const uint8_t b : encode(identity)) {
        out.put8(b);
    }
    out.put32(crc32(0, out.bytes().data(), out.bytes().size()));
    return out.bytes();
}

RowFile::RowFile(std::unique_ptr<PosixFile> file)
    : file_(std::move(file)),
      head_(read_head(*file_)),
      identity_(decode_identity(head_.data() + kMagicBytes + 4)),
      layout_(identity_.layout()),
      rows_(layout_.used_origins, identity_.shard),
      // Without the CRC at its end: with it, every head would have the same one.
      head_crc_(crc32(0, head_.data(), head_.size() - kSealBytes))
{
}

uint64_t RowFile::slot_offset(uint32_t slot) const
{
    const uint64_t first = kHeadBytes + (has_palette() ? kSealBytes + format::kPaletteBytes : 0);
    return first + uint64_t{slot} * (kSealBytes + layout_.row_stride());
}

uint32_t RowFile::seal(uint32_t number, const uint8_t* bytes, size_t size) const
{
    ByteWriter prefix;
    prefix.put32(number);
    return crc32(crc32(head_crc_, prefix.bytes().data(), prefix.bytes().size()), bytes, size);
}

bool RowFile::read_sealed(uint64_t offset, uint32_t number, std::vector<uint8_t>& bytes) const
{
    uint8_t stored[kSealBytes];
    return file_->read_at(offset, stored, kSealBytes) == kSealBytes &&
           file_->read_at(offset + kSealBytes, bytes.data(), bytes.size()) == bytes.size() &&
           ByteReader(stored, kSealBytes).get32() == seal(number, bytes.data(), bytes.size());
}

void RowFile::write_sealed(uint64_t offset, uint32_t number, const std::vector<uint8_t>& bytes)
{
    ByteWriter out;
    out.put32(seal(number, bytes.data(), bytes.size()));
    std::vector<uint8_t> sealed = out.bytes();
    sealed.insert(sealed.end(), bytes.begin(), bytes.end());
    file_->write_at(offset, sealed.data(), sealed.size());
}

bool RowFile::read_row(uint32_t slot, std::vector<uint8_t>& row) const
{
    row.resize(layout_.row_stride());
    return read_sealed(slot_offset(slot), row_of(slot), row);
}

void RowFile::write_row(uint32_t slot, const std::vector<uint8_t>& row)
{
    write_sealed(slot_offset(slot), row_of(slot), row);
}

bool RowFile::read_palette(Palette& palette) const
{
    if (!has_palette()) {
        return true;
    }
    std::vector<uint8_t> bytes(format::kPaletteBytes);
    if (!read_sealed(kHeadBytes, kPaletteNumber, bytes)) {
        return false;
    }
    for (size_t k = 0; k < palette.size(); ++k) {
        palette[k] = {bytes[4 * k], bytes[4 * k + 1], bytes[4 * k + 2], bytes[4 * k + 3]};
    }
    return true;
}

void RowFile::write_palette(const Palette& palette)
{
    write_sealed(kHeadBytes, kPaletteNumber, bytes_of(palette));
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
    for (uint32_t slot = 0; slot < rows.slot_count(); ++slot) {
        if (!rows.read_row(slot, row)) {
            missing.push_back(slot);
        }
    }
    return missing;
}

}  // namespace lumi::baker
