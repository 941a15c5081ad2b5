// SPDX-License-Identifier: MIT
#include "files/sha256.h"

#include <array>
#include <cstdio>
#include <vector>

namespace lumi::tools
{

namespace
{

constexpr size_t kBlockBytes = 64;

// The first 32 bits of the fractions of the cube roots of the first 64 primes, section 4.2.2.
constexpr uint32_t kRound[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

using State = std::array<uint32_t, 8>;

uint32_t turned(uint32_t v, unsigned bits)
{
    return v >> bits | v << (32 - bits);
}

std::array<uint32_t, 64> schedule(const uint8_t* block)
{
    std::array<uint32_t, 64> w;
    for (size_t t = 0; t < 16; ++t) {
        const uint8_t* b = block + 4 * t;
        w[t] = static_cast<uint32_t>(b[0]) << 24 | static_cast<uint32_t>(b[1]) << 16 |
               static_cast<uint32_t>(b[2]) << 8 | b[3];
    }
    for (size_t t = 16; t < 64; ++t) {
        const uint32_t before2 = w[t - 2], before15 = w[t - 15];
        w[t] = w[t - 16] + w[t - 7] + (turned(before15, 7) ^ turned(before15, 18) ^ before15 >> 3) +
               (turned(before2, 17) ^ turned(before2, 19) ^ before2 >> 10);
    }
    return w;
}

void add_block(State& state, const uint8_t* block)
{
    const auto w = schedule(block);
    auto [a, b, c, d, e, f, g, h] = state;
    for (size_t t = 0; t < 64; ++t) {
        const uint32_t first =
            h + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) + ((e & f) ^ (~e & g)) + kRound[t] + w[t];
        const uint32_t second = (turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
        h = g;
        g = f;
        f = e;
        e = d + first;
        d = c;
        c = b;
        b = a;
        a = first + second;
    }
    const State sum = {a, b, c, d, e, f, g, h};
    for (size_t k = 0; k < state.size(); ++k) state[k] += sum[k];
}

// What is left of a message, a one, zeros, and the number of bits.
std::vector<uint8_t> closing(const uint8_t* rest, size_t rest_bytes, uint64_t all_bytes)
{
    std::vector<uint8_t> b(rest, rest + rest_bytes);
    b.push_back(0x80);
    while (b.size() % kBlockBytes != kBlockBytes - 8) b.push_back(0);
    for (int shift = 56; shift >= 0; shift -= 8) b.push_back(static_cast<uint8_t>(8 * all_bytes >> shift));
    return b;
}

}  // namespace

std::string sha256(const uint8_t* bytes, size_t size)
{
    State state = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    const size_t whole = size / kBlockBytes * kBlockBytes;
    for (size_t at = 0; at < whole; at += kBlockBytes) add_block(state, bytes + at);
    const std::vector<uint8_t> end = closing(bytes + whole, size - whole, size);
    for (size_t at = 0; at < end.size(); at += kBlockBytes) add_block(state, end.data() + at);
    std::string text;
    for (const uint32_t word : state) {
        char digits[9];
        std::snprintf(digits, sizeof digits, "%08x", word);
        text += digits;
    }
    return text;
}

}  // namespace lumi::tools
