// SPDX-License-Identifier: MIT
// sRGB-encoded levels as linear light and back: for pixels in which several surfaces meet. Linked only if used: 512
// bytes of table.
#pragma once

#include <cstdint>

#include "lumi/color.h"

namespace lumi
{

// Light of encoded levels, Q16 (65,535 is white); IEC 61966-2-1.
struct LinearLight {
    uint16_t at[256];
};
extern const LinearLight kLinearLight;

// The level whose light is nearest; about 40 instructions.
uint8_t encoded_level(uint32_t light);

// Colours mixed in linear light by their weights, which sum to at most 4.
class LightMixture
{
public:
    void add(const Rgb8& colour, uint32_t weight)
    {
        r_ += kLinearLight.at[colour.r] * weight;
        g_ += kLinearLight.at[colour.g] * weight;
        b_ += kLinearLight.at[colour.b] * weight;
        weight_ += weight;
    }

    uint32_t weight() const { return weight_; }
    // Their mean. weight() > 0.
    Rgb8 colour() const;

private:
    uint32_t r_ = 0, g_ = 0, b_ = 0, weight_ = 0;
};

}  // namespace lumi
