// SPDX-License-Identifier: MIT
#include "math/sampler.h"

namespace lumi::baker
{
namespace
{

// Beyond these, stratification no longer shows in a path's variance and the cheaper hash serves.
constexpr uint32_t kStratifiedDimensions = 24;
constexpr uint64_t kGoldenStep = 0x9E3779B97F4A7C15u;  // 2^64/Φ, odd: steps through all 64-bit values

// Finalizer of SplitMix64: Steele et al., "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014.
uint64_t mix(uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

uint32_t reverse_bits(uint32_t x)
{
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0F0F0F0Fu) | (x & 0x0F0F0F0Fu) << 4;
    return __builtin_bswap32(x);
}

// A random permutation in which each bit depends on lower bits only: Owen scrambling of bit-reversed fractions.
// Laine & Karras 2011 with the constants of N. Vegdahl, "Building a Better LK Hash", 2021.
uint32_t owen_hash(uint32_t x, uint32_t seed)
{
    x ^= x * 0x3D20ADEAu;
    x += seed;
    x *= (seed >> 16) | 1;
    x ^= x * 0x05526C56u;
    x ^= x * 0x53A22864u;
    return x;
}

float unit_float(uint32_t bits)
{
    constexpr float kScale = 0x1p-24f;  // 24 bits: the largest result rounds below 1
    return static_cast<float>(bits >> 8) * kScale;
}

}  // namespace

uint32_t sobol_second_dimension_reversed(uint32_t index)
{
    // The generator is Pascal's triangle modulo 2, a Kronecker power of one 2×2 block: five butterflies.
    index ^= (index & 0xAAAAAAAAu) >> 1;
    index ^= (index & 0xCCCCCCCCu) >> 2;
    index ^= (index & 0xF0F0F0F0u) >> 4;
    index ^= (index & 0xFF00FF00u) >> 8;
    index ^= (index & 0xFFFF0000u) >> 16;
    return index;
}

Sampler::Sampler(uint64_t seed, uint32_t i, uint32_t j)
    : key_(mix(mix(seed + kGoldenStep) ^ (static_cast<uint64_t>(i) << 32 | j)))
{
}

void Sampler::start(uint32_t sample)
{
    sample_ = sample;
    reversed_sample_ = reverse_bits(sample);
    dimension_ = 0;
}

uint64_t Sampler::next_hash()
{
    ++dimension_;
    const bool stratified = dimension_ <= kStratifiedDimensions;
    const uint64_t own = stratified ? 0 : static_cast<uint64_t>(sample_) + 1;
    return mix(key_ + kGoldenStep * (static_cast<uint64_t>(dimension_) << 32 | own));
}

float Sampler::next_1d()
{
    const uint64_t hash = next_hash();
    const uint32_t low = static_cast<uint32_t>(hash);
    if (dimension_ > kStratifiedDimensions) return unit_float(low);
    const uint32_t index = reverse_bits(owen_hash(reversed_sample_, low));
    return unit_float(reverse_bits(owen_hash(index, static_cast<uint32_t>(hash >> 32))));
}

Vec2 Sampler::next_2d()
{
    const uint64_t hash = next_hash();
    const uint32_t low = static_cast<uint32_t>(hash);
    const uint32_t high = static_cast<uint32_t>(hash >> 32);
    if (dimension_ > kStratifiedDimensions) return {unit_float(low), unit_float(high)};
    const uint32_t index = reverse_bits(owen_hash(reversed_sample_, low));
    const uint32_t second_seed = static_cast<uint32_t>(mix(hash) >> 32);
    return {unit_float(reverse_bits(owen_hash(index, high))),
            unit_float(reverse_bits(owen_hash(sobol_second_dimension_reversed(index), second_seed)))};
}

}  // namespace lumi::baker
