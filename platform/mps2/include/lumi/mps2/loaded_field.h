// SPDX-License-Identifier: MIT
// Fields that the emulator's loader (`-device loader,file=F,addr=A,force-raw=on`) put into the board's 16 MB PSRAM:
// what a firmware does that finds its field in a flash partition of its own.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lumi::mps2
{

inline constexpr uint32_t kLoadedFieldMemoryBytes = 16u * 1024 * 1024;

struct LoadedField {
    const uint8_t* bytes;
    size_t size;  // as the file's own header tells, cut off at the end of the memory; open_field decides the rest
};

// The field `offset` bytes into the PSRAM; offset < kLoadedFieldMemoryBytes.
LoadedField loaded_field(uint32_t offset);

}  // namespace lumi::mps2
