// SPDX-License-Identifier: MIT
// CRC-32 (IEEE 802.3, reflected polynomial 0xEDB88320), as used by zip and PNG.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "lumi/detail/compiler.h"

namespace lumi::detail
{

// Continues `previous` (0 to begin) over `size` bytes: crc32(crc32(0, a), b) is the CRC of a followed by b.
// A 64-byte table; about 12 instructions a byte.
uint32_t crc32(uint32_t previous, const uint8_t* bytes, size_t size);

}  // namespace lumi::detail
