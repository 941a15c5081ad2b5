// SPDX-License-Identifier: MIT
// Little-endian numbers one after the other.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace lumi::baker
{

class ByteWriter
{
public:
    void put8(uint8_t v) { bytes_.push_back(v); }
    void put32(uint32_t v)
    {
        for (int shift = 0; shift < 32; shift += 8) put8(static_cast<uint8_t>(v >> shift));
    }
    void put64(uint64_t v)
    {
        put32(static_cast<uint32_t>(v));
        put32(static_cast<uint32_t>(v >> 32));
    }
    void put_float(float v)
    {
        uint32_t bits = 0;
        static_assert(sizeof bits == sizeof v, "files store IEEE binary32");
        std::memcpy(&bits, &v, sizeof bits);
        put32(bits);
    }
    void put_double(double v)
    {
        uint64_t bits = 0;
        static_assert(sizeof bits == sizeof v, "files store IEEE binary64");
        std::memcpy(&bits, &v, sizeof bits);
        put64(bits);
    }
    const std::vector<uint8_t>& bytes() const { return bytes_; }

private:
    std::vector<uint8_t> bytes_;
};

// Reads zeros after the end.
class ByteReader
{
public:
    ByteReader(const uint8_t* bytes, size_t size) : bytes_(bytes), left_(size) {}

    size_t left() const { return left_; }

    uint8_t get8() { return left_ == 0 ? uint8_t{0} : (--left_, *bytes_++); }
    uint32_t get32()
    {
        uint32_t v = 0;
        for (int shift = 0; shift < 32; shift += 8) v |= uint32_t{get8()} << shift;
        return v;
    }
    uint64_t get64()
    {
        const uint64_t low = get32();
        return low | uint64_t{get32()} << 32;
    }
    float get_float()
    {
        const uint32_t bits = get32();
        float v = 0;
        std::memcpy(&v, &bits, sizeof v);
        return v;
    }

    double get_double()
    {
        const uint64_t bits = get64();
        double v = 0;
        std::memcpy(&v, &bits, sizeof v);
        return v;
    }

private:
    const uint8_t* bytes_;
    size_t left_;
};

}  // namespace lumi::baker
