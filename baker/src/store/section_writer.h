// SPDX-License-Identifier: MIT
// Writes the container of field files (lumi/field_format.h): bytes of sections, and the header and table before them.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "lumi/field_format.h"

namespace lumi::baker
{

// Little-endian numbers at fixed places.
class Bytes
{
public:
    explicit Bytes(size_t size) : bytes_(size) {}

    void put8(size_t at, uint8_t v) { bytes_[at] = v; }
    void put16(size_t at, uint16_t v)
    {
        put8(at, static_cast<uint8_t>(v & 0xFF));
        put8(at + 1, static_cast<uint8_t>(v >> 8));
    }
    void put32(size_t at, uint32_t v)
    {
        put16(at, static_cast<uint16_t>(v & 0xFFFF));
        put16(at + 2, static_cast<uint16_t>(v >> 16));
    }
    void put_float(size_t at, float v)
    {
        uint32_t bits = 0;
        static_assert(sizeof bits == sizeof v, "the format stores IEEE binary32");
        std::memcpy(&bits, &v, sizeof bits);
        put32(at, bits);
    }
    std::vector<uint8_t> take() { return std::move(bytes_); }

private:
    std::vector<uint8_t> bytes_;
};

// A section that follows the one before it at the next multiple of kSectionAlignment.
struct Section {
    uint32_t type;
    uint64_t size;
    uint32_t crc;
    uint32_t flags = detail::format::kRequired;
};

constexpr uint64_t aligned(uint64_t size)
{
    return (size + detail::format::kSectionAlignment - 1) / detail::format::kSectionAlignment *
           detail::format::kSectionAlignment;
}

uint32_t crc_of(const std::vector<uint8_t>& bytes);

// Where the first section begins.
uint64_t head_bytes(size_t sections);
// Header and section table, head_bytes() long.
std::vector<uint8_t> file_head(const std::vector<Section>& sections);

}  // namespace lumi::baker
