// SPDX-License-Identifier: MIT
// Our form of the AgX view transform: channels are mixed, each goes through a curve in the shape of a film's, and they
// are unmixed. The mixing is what lets a strong colour fade: its curve's end is reached by all channels together.
//
// AgX itself mixes by a matrix of primaries and takes its curve from a table over the logarithm of light. Here each
// channel takes a share of the mean, as large as the mean of that matrix's other entries, and the curve is x^p/(x^p +
// k), on which light of 0.18 stays 0.18. Greys stay greys.
#pragma once

#include <cmath>

#include "math/vec3.h"

namespace lumi::baker::agx
{

inline constexpr float kPower = 1.23f, kHalf = 0.553f;  // p and k
inline constexpr float kShare = 0.2f;                   // of the mean, in each mixed channel

inline Rgb mixed(const Rgb& c)
{
    return c * (1 - kShare) + grey(kShare * (c.r + c.g + c.b) / 3);
}

// Undoes mixed(), which leaves the mean as it is.
inline Rgb unmixed(const Rgb& c)
{
    return (c - grey(kShare * (c.r + c.g + c.b) / 3)) * (1 / (1 - kShare));
}

inline float curve(float x)
{
    const float power = std::pow(std::max(x, 0.0f), kPower);
    return power / (power + kHalf);
}

// The light that the curve takes to y, for y in [0, 1).
inline float inverse_curve(float y)
{
    return std::pow(kHalf * y / (1 - y), 1 / kPower);
}

// Its derivative, for x above 0.
inline float slope(float x)
{
    const float power = std::pow(x, kPower), sum = power + kHalf;
    return kPower * kHalf * power / (x * sum * sum);
}

}  // namespace lumi::baker::agx
