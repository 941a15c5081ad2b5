// SPDX-License-Identifier: MIT
// UF2, the file format that boards with a USB boot loader flash when it is copied onto their drive
// (https://github.com/microsoft/uf2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace lumi::tools
{

enum class Uf2Family : uint32_t {
    rp2040 = 0xE48BFF56,
    rp2350 = 0xE48BFF57,  // "absolute": data at any address
};

// Where the boot loader of a family flashes bytes, as the processor sees them.
struct FlashRange {
    uint32_t begin, end;
};
FlashRange flash_of(Uf2Family family);

// A boot loader erases so much at once. Bytes of other programs in a file's last sector are lost.
inline constexpr uint32_t kUf2SectorBytes = 4096;

// `address` is divisible by kUf2SectorBytes, and address + size at most 2^32.
std::string uf2_of(const uint8_t* bytes, size_t size, uint32_t address, Uf2Family family);

}  // namespace lumi::tools
