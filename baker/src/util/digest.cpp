// SPDX-License-Identifier: MIT
#include "util/digest.h"

#include <cstring>

namespace lumi::baker
{
namespace
{

// Odd constants without structure: 2^64 divided by the golden ratio, and by the square root of 2.
constexpr uint64_t kGolden = 0x9E3779B97F4A7C15u;
constexpr uint64_t kRootHalf = 0xB504F333F9DE6485u;

uint64_t rotated(uint64_t v, int bits)
{
    return v << bits | v >> (64 - bits);
}

// The finalizer of SplitMix64 (Steele, Lea & Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014).
uint64_t mixed(uint64_t v)
{
    v = (v ^ (v >> 30)) * 0xBF58476D1CE4E5B9u;
    v = (v ^ (v >> 27)) * 0x94D049BB133111EBu;
    return v ^ (v >> 31);
}

}  // namespace

void Digest::add_word(uint64_t word)
{
    state_[0] = rotated(state_[0] ^ mixed(word + kGolden), 29) * kGolden + state_[1];
    state_[1] = rotated(state_[1] + word, 31) * kRootHalf ^ state_[0];
}

void Digest::add_bytes(const void* bytes, size_t size)
{
    add_word(size);
    const auto* at = static_cast<const uint8_t*>(bytes);
    for (uint64_t word = 0; size > 0;) {
        const size_t count = size < sizeof word ? size : sizeof word;
        word = 0;
        std::memcpy(&word, at, count);
        add_word(word);
        at += count;
        size -= count;
    }
}

Digest::Value Digest::value() const
{
    return {mixed(state_[0] ^ rotated(state_[1], 32)), mixed(state_[1] + kGolden * mixed(state_[0]))};
}

}  // namespace lumi::baker
