// SPDX-License-Identifier: MIT
// Little-endian numbers one after the other.
//
// A struct says once what it holds, for both directions:
//
//   template <class Io> void fields(Io& io, Sample& s) { io(s.triangle, s.radiance); }
//
// Io is a ByteWriter, which changes nothing, or a ByteReader. Vectors are preceded by their length in 64 bits; of enums
// anything may be read.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace lumi::baker
{

class ByteWriter
{
public:
    void put8(uint8_t v) { bytes_.push_back(v); }
    void put32(uint32_t v) { put(v); }
    void put64(uint64_t v) { put(v); }
    void put_float(float v) { put(v); }
    void put_double(double v) { put(v); }

    template <class... T>
    void operator()(const T&... values)
    {
        (put(values), ...);
    }
    void require(bool) {}

    const std::vector<uint8_t>& bytes() const { return bytes_; }

private:
    template <class T>
    void put(const T& v)
    {
        if constexpr (std::is_same_v<T, bool>)
            put8(v ? 1 : 0);
        else if constexpr (std::is_enum_v<T>)
            put(static_cast<std::underlying_type_t<T>>(v));
        else if constexpr (std::is_integral_v<T>)
            for (size_t shift = 0; shift < 8 * sizeof v; shift += 8) put8(static_cast<uint8_t>(v >> shift));
        else if constexpr (std::is_same_v<T, float>)
            put(bits_of<uint32_t>(v));
        else if constexpr (std::is_same_v<T, double>)
            put(bits_of<uint64_t>(v));
        else
            fields(*this, const_cast<T&>(v));
    }
    void put(const std::string& text)
    {
        put64(text.size());
        for (const char c : text) put8(static_cast<uint8_t>(c));
    }
    template <class T>
    void put(const std::vector<T>& values)
    {
        put64(values.size());
        for (const T& v : values) put(v);
    }
    template <class T, size_t kSize>
    void put(const std::array<T, kSize>& values)
    {
        for (const T& v : values) put(v);
    }
    template <class Bits, class T>
    static Bits bits_of(T v)
    {
        static_assert(sizeof(Bits) == sizeof v, "files store IEEE binary32 and binary64");
        Bits bits = 0;
        std::memcpy(&bits, &v, sizeof v);
        return bits;
    }

    std::vector<uint8_t> bytes_;
};

// Reads zeros after the end.
class ByteReader
{
public:
    ByteReader(const uint8_t* bytes, size_t size) : bytes_(bytes), left_(size) {}

    uint8_t get8()
    {
        require(left_ != 0);
        return left_ == 0 ? uint8_t{0} : (--left_, *bytes_++);
    }
    uint32_t get32() { return got<uint32_t>(); }
    uint64_t get64() { return got<uint64_t>(); }
    float get_float() { return got<float>(); }

    template <class... T>
    void operator()(T&... values)
    {
        (get(values), ...);
    }
    // Once false, the bytes are none of what they should be.
    void require(bool sound) { sound_ = sound_ && sound; }
    // Whether all was there and sound, and nothing is left.
    bool is_complete() const { return sound_ && left_ == 0; }

private:
    template <class T>
    T got()
    {
        T v = {};
        get(v);
        return v;
    }
    template <class T>
    void get(T& v)
    {
        if constexpr (std::is_same_v<T, bool>) {
            v = get8() != 0;
        } else if constexpr (std::is_enum_v<T>) {
            v = static_cast<T>(got<std::underlying_type_t<T>>());
        } else if constexpr (std::is_integral_v<T>) {
            uint64_t bits = 0;
            for (size_t shift = 0; shift < 8 * sizeof v; shift += 8) bits |= uint64_t{get8()} << shift;
            v = static_cast<T>(bits);
        } else if constexpr (std::is_floating_point_v<T>) {
            const auto bits = got<std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>>();
            std::memcpy(&v, &bits, sizeof v);
        } else {
            fields(*this, v);
        }
    }
    void get(std::string& text)
    {
        text.clear();
        for (uint64_t left = get64(); left != 0 && sound_; --left) text.push_back(static_cast<char>(get8()));
    }
    // Grows as entries arrive: sizes may be anything.
    template <class T>
    void get(std::vector<T>& values)
    {
        values.clear();
        for (uint64_t left = get64(); left != 0 && sound_; --left) get(values.emplace_back());
    }
    template <class T, size_t kSize>
    void get(std::array<T, kSize>& values)
    {
        for (T& v : values) get(v);
    }

    const uint8_t* bytes_;
    size_t left_;
    bool sound_ = true;
};

template <class T>
std::vector<uint8_t> to_bytes(const T& value)
{
    ByteWriter out;
    out(value);
    return out.bytes();
}

// Nothing where the bytes are not those of a value, whole and sound.
template <class T>
std::optional<T> from_bytes(const std::vector<uint8_t>& bytes)
{
    ByteReader in(bytes.data(), bytes.size());
    T value = {};
    in(value);
    if (!in.is_complete()) return std::nullopt;
    return value;
}

}  // namespace lumi::baker
