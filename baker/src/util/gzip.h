// SPDX-License-Identifier: MIT
// Unpacks gzip (RFC 1952).
#pragma once

#include <cstddef>
#include <string>

namespace lumi::baker
{

bool is_gzip(const std::string& bytes);

// The first `most` bytes of what is packed, or fewer where the file ends or is damaged earlier. The checksum is not
// looked at unless all was asked for. Memory: what it returns.
std::string unpack_gzip(const std::string& bytes, size_t most);

}  // namespace lumi::baker
