// SPDX-License-Identifier: MIT
// The random numbers of one texel or pixel.
//
// Every number is a pure function of (seed, i, j, sample, dimension): results depend neither on threads nor on the
// order of work. The first dimensions are Owen-scrambled (0,2)-sequences, shuffled anew per dimension pair, after
// Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020; later ones are plain hashes.
//
// Use: for each sample s: start(s), then draw numbers in a fixed order.
#pragma once

#include <cstdint>

#include "math/vec3.h"

namespace lumi::baker
{

class Sampler
{
public:
    Sampler(uint64_t seed, uint32_t i, uint32_t j);

    void start(uint32_t sample);

    float next_1d();  // in [0, 1)
    Vec2 next_2d();   // in [0, 1)²
    // Passes over a next_1d whose number nobody would look at; what follows stays as it is.
    void skip_1d() { ++dimension_; }

private:
    uint64_t next_hash();

    uint64_t key_;
    uint32_t sample_ = 0, reversed_sample_ = 0;
    uint32_t dimension_ = 0;
};

// Base-2 Sobol' points without scrambling, as 32-bit fractions; bit-reversed (lowest bit is the half). For tests.
uint32_t sobol_second_dimension_reversed(uint32_t index);

}  // namespace lumi::baker
