// SPDX-License-Identifier: MIT
// A 128-bit hash of whatever is added, in order. It tells different inputs apart; it does not withstand an attacker.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace lumi::baker
{

class Digest
{
public:
    using Value = std::array<uint64_t, 2>;

    void add_bytes(const void* bytes, size_t size);  // adds the bytes and their count
    void add(const std::string& text) { add_bytes(text.data(), text.size()); }

    // Takes numbers, and structs of nothing but numbers of one size, which have no padding.
    template <class T>
    void add(const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>, "only plain values have bytes of their own");
        static_assert(!std::is_pointer_v<T>, "an address says nothing about what lies there");
        add_bytes(&value, sizeof value);
    }
    template <class T>
    void add(const std::vector<T>& values)
    {
        static_assert(std::is_trivially_copyable_v<T>, "only plain values have bytes of their own");
        add_bytes(values.data(), values.size() * sizeof(T));
    }

    Value value() const;

private:
    void add_word(uint64_t word);

    std::array<uint64_t, 2> state_ = {0x243F6A8885A308D3u, 0x13198A2E03707344u};  // digits of pi
};

}  // namespace lumi::baker
