// SPDX-License-Identifier: MIT
// From mean linear radiance to what displays take: tone curves, and the transfer function of sRGB (IEC 61966-2-1).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "lumi/color.h"
#include "math/vec3.h"

namespace lumi::baker
{

// They take any number and clip nothing: 1 stands for white on both sides.
double srgb_linear(double encoded);
double srgb_encoded(double linear);
Rgb srgb_linear(const Rgb& encoded);

float srgb_decode(uint8_t encoded);

// Both clip to [0, 1]. Not-a-number becomes 0.
float srgb_encode_unit(float linear);
Rgb8 srgb_encode(const Rgb& linear);

enum class ToneCurve : uint8_t {
    srgb,      // none: radiance above 1 clips
    reinhard,  // luminance L becomes L/(1+L): Reinhard et al., "Photographic Tone Reproduction for Digital Images",
               // SIGGRAPH 2002, equation 3; hue stays
    aces,      // a fit of the ACES filmic curve per channel: K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2016
    agx,  // like AgX (T. Sobotka, github.com/sobotka/AgX, 2022; Blender's default since 4.0): strong colours fade to
          // white as they get brighter
};
inline constexpr ToneCurve kLastToneCurve = ToneCurve::agx;

// Still linear; values above 1 clip later, and so do those below 0 that AgX gives to dark, strong colours. Light below
// 0, as fits to noise may have it, is shown as none.
Rgb toned(ToneCurve curve, const Rgb& radiance);

// Our form of the AgX view transform: channels are mixed, each goes through a curve in the shape of a film's, and they
// are unmixed. The mixing is what lets a strong colour fade: its curve's end is reached by all channels together.
//
// AgX itself mixes by a matrix of primaries and takes its curve from a table over the logarithm of light. Here each
// channel takes a share of the mean, as large as the mean of that matrix's other entries, and the curve is x^p/(x^p +
// k), on which light of 0.18 stays 0.18. Greys stay greys.
namespace agx
{

inline constexpr float kPower = 1.23f, kHalf = 0.553f;  // p and k
inline constexpr float kShare = 0.2f;                   // each mixed channel has so much of the mean

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

// The derivative of curve(), which exists for x above 0.
inline float slope(float x)
{
    const float power = std::pow(x, kPower), sum = power + kHalf;
    return kPower * kHalf * power / (x * sum * sum);
}

}  // namespace agx

}  // namespace lumi::baker
