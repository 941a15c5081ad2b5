// SPDX-License-Identifier: MIT
// sRGB's levels 0 .. 255 and linear light 0 .. 1 (IEC 61966-2-1), in double precision.
#pragma once

#include <cmath>

namespace lumi::test
{

inline double light_of_level(double level)
{
    const double v = level / 255;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

inline double level_of_light(double light)
{
    return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

}  // namespace lumi::test
