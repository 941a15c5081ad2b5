// SPDX-License-Identifier: MIT
// The transfer function of sRGB, IEC 61966-2-1.
#pragma once

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

}  // namespace lumi::baker
