// SPDX-License-Identifier: MIT
// Unpacks gzip (RFC 1952), and packs and checks what a bake keeps on disk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lumi::baker
{

bool is_gzip(const std::string& bytes);

// The first `most` bytes of what is packed, or fewer where the file ends or is damaged earlier. The checksum is not
// looked at unless all was asked for. Memory: what it returns.
std::string unpack_gzip(const std::string& bytes, size_t most);

// For bytes that are written often and hardly ever read: fast rather than small.
std::vector<uint8_t> packed(const std::vector<uint8_t>& bytes);
// Nothing where they are not what packed() made.
std::optional<std::vector<uint8_t>> unpacked(const std::vector<uint8_t>& bytes);

// CRC-32 as core's, in a tenth of the time. Continues `previous`, 0 to begin.
uint32_t checksum(uint32_t previous, const uint8_t* bytes, size_t size);

}  // namespace lumi::baker
