// SPDX-License-Identifier: MIT
// SHA-256 (FIPS 180-4), by which people name the very file that figures are of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace lumi::tools
{

// 64 digits, lower case.
std::string sha256(const uint8_t* bytes, size_t size);

}  // namespace lumi::tools
