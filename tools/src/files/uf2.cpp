// SPDX-License-Identifier: MIT
#include "files/uf2.h"

#include <algorithm>

namespace lumi::tools
{

namespace
{

constexpr size_t kUf2BlockBytes = 512, kHeaderBytes = 32, kPayloadBytes = 256;  // a page of flash a block
constexpr uint32_t kFirstMagic = 0x0A324655, kSecondMagic = 0x9E5D5157, kLastMagic = 0x0AB16F30;
constexpr uint32_t kHasFamily = 0x2000;

void put(std::string& text, uint32_t word)
{
    for (int shift = 0; shift < 32; shift += 8) text += static_cast<char>(word >> shift & 0xFF);
}

}  // namespace

// The windows of the datasheets: 16 MB behind one chip select, of which an RP2350 has two.
FlashRange flash_of(Uf2Family family)
{
    switch (family) {
        case Uf2Family::rp2040:
            return {0x10000000, 0x11000000};
        case Uf2Family::rp2350:
            return {0x10000000, 0x12000000};
    }
    return {};
}

std::string uf2_of(const uint8_t* bytes, size_t size, uint32_t address, Uf2Family family)
{
    const size_t blocks = (size + kPayloadBytes - 1) / kPayloadBytes;
    std::string text;
    for (size_t k = 0; k < blocks; ++k) {
        const size_t from = k * kPayloadBytes, count = std::min(kPayloadBytes, size - from);
        for (const uint32_t word : {kFirstMagic, kSecondMagic, kHasFamily, address + static_cast<uint32_t>(from),
                                    static_cast<uint32_t>(kPayloadBytes), static_cast<uint32_t>(k),
                                    static_cast<uint32_t>(blocks), static_cast<uint32_t>(family)})
            put(text, word);
        text.append(reinterpret_cast<const char*>(bytes) + from, count);
        text.append(kUf2BlockBytes - kHeaderBytes - count - sizeof kLastMagic, '\0');
        put(text, kLastMagic);
    }
    return text;
}

}  // namespace lumi::tools
