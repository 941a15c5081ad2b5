// SPDX-License-Identifier: MIT
#include "store/section_writer.h"

#include "lumi/detail/crc32.h"

namespace lumi::baker
{
namespace
{

uint64_t file_bytes(const std::vector<Section>& sections)
{
    uint64_t bytes = head_bytes(sections.size());
    for (const Section& section : sections) bytes += aligned(section.size);
    return bytes;
}

std::vector<uint8_t> section_table(const std::vector<Section>& sections)
{
    namespace at = detail::format::entry;
    Bytes b(sections.size() * detail::format::kEntryBytes);
    uint64_t offset = head_bytes(sections.size());
    for (size_t k = 0; k < sections.size(); ++k) {
        const size_t entry = k * detail::format::kEntryBytes;
        b.put32(entry + at::kTypeAt, sections[k].type);
        b.put32(entry + at::kFlagsAt, sections[k].flags);
        b.put32(entry + at::kOffsetAt, static_cast<uint32_t>(offset));
        b.put32(entry + at::kSizeAt, static_cast<uint32_t>(sections[k].size));
        b.put32(entry + at::kCrcAt, sections[k].crc);
        offset += aligned(sections[k].size);
    }
    return b.take();
}

std::vector<uint8_t> file_header(uint64_t size, const std::vector<uint8_t>& table)
{
    namespace at = detail::format::header;
    Bytes b(at::kHeaderCrcAt);
    for (size_t k = 0; k < sizeof detail::format::kMagic; ++k) b.put8(at::kMagicAt + k, detail::format::kMagic[k]);
    b.put16(at::kVersionAt, detail::format::kVersion);
    b.put16(at::kHeaderBytesAt, static_cast<uint16_t>(detail::format::kHeaderBytes));
    b.put32(at::kFileBytesAt, static_cast<uint32_t>(size));
    b.put16(at::kSectionCountAt, static_cast<uint16_t>(table.size() / detail::format::kEntryBytes));
    b.put16(at::kEntryBytesAt, static_cast<uint16_t>(detail::format::kEntryBytes));
    b.put32(at::kTableCrcAt, crc_of(table));
    std::vector<uint8_t> header = b.take();
    Bytes crc(sizeof(uint32_t));
    crc.put32(0, crc_of(header));
    const std::vector<uint8_t> seal = crc.take();
    header.insert(header.end(), seal.begin(), seal.end());
    return header;
}

}  // namespace

uint32_t crc_of(const std::vector<uint8_t>& bytes)
{
    return detail::crc32(0, bytes.data(), bytes.size());
}

uint64_t head_bytes(size_t sections)
{
    return aligned(detail::format::kHeaderBytes + sections * detail::format::kEntryBytes);
}

std::vector<uint8_t> file_head(const std::vector<Section>& sections)
{
    const std::vector<uint8_t> table = section_table(sections);
    std::vector<uint8_t> head = file_header(file_bytes(sections), table);
    head.insert(head.end(), table.begin(), table.end());
    head.resize(head_bytes(sections.size()));
    return head;
}

}  // namespace lumi::baker
